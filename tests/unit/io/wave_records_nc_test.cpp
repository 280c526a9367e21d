#include "io/wave_records_nc.h"

#include <doctest/doctest.h>
#include <netcdf.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

const double dry = std::numeric_limits<double>::quiet_NaN();

struct File {
    int id = -1;
    explicit File(const std::filesystem::path& path) {
        REQUIRE(nc_open(path.c_str(), NC_NOWRITE, &id) == NC_NOERR);
    }
    ~File() { nc_close(id); }
    int variable(const char* name) const {
        int variable = -1;
        REQUIRE(nc_inq_varid(id, name, &variable) == NC_NOERR);
        return variable;
    }
    std::string text(const char* name, const char* attribute) const {
        const int variable_id = *name ? variable(name) : NC_GLOBAL;
        std::size_t size = 0;
        REQUIRE(nc_inq_attlen(id, variable_id, attribute, &size) == NC_NOERR);
        std::string value(size, ' ');
        nc_get_att_text(id, variable_id, attribute, value.data());
        return value;
    }
    std::vector<double> values(const char* name, std::size_t count) const {
        std::vector<double> values(count);
        REQUIRE(nc_get_var_double(id, variable(name), values.data()) == NC_NOERR);
        return values;
    }
};

const GaugeRecords two_gauges{
    .title = "A wave",
    .time = {0.0, 0.5, 1.25},
    .stations = {{"x=2", 2.0, 0.0, {0.0, 0.1, dry}}, {"x=12.5", 12.5, 3.0, {0.0, -0.1, 0.2}}}};

}  // namespace

TEST_CASE("gauges are a CF time series of each station") {
    const TemporaryFolder folder;
    write_gauges_nc(folder / "gauges.nc", two_gauges, test_provenance());
    const File file(folder / "gauges.nc");
    CHECK(file.text("", "Conventions") == "CF-1.8");
    CHECK(file.text("", "featureType") == "timeSeries");
    CHECK(file.text("", "scene_hash") == test_provenance().scene_hash);
    CHECK(file.text("time", "units") == "seconds since 2000-01-01 00:00:00");
    CHECK(file.text("station_name", "cf_role") == "timeseries_id");
    CHECK(file.text("eta", "standard_name") == "sea_surface_height_above_mean_sea_level");
    CHECK(file.text("eta", "coordinates") == "x y station_name");
    CHECK(file.values("time", 3) == two_gauges.time);
    CHECK(file.values("x", 2) == std::vector{2.0, 12.5});
    CHECK(file.values("y", 2) == std::vector{0.0, 3.0});
    const auto eta = file.values("eta", 6);
    CHECK(eta[1] == 0.1);
    CHECK(std::isnan(eta[2]));
    CHECK(eta[5] == 0.2);
    std::string names(12, ' ');
    REQUIRE(nc_get_var_text(file.id, file.variable("station_name"), names.data()) == NC_NOERR);
    CHECK(names == std::string("x=2\0\0\0x=12.5", 12));
}

TEST_CASE("a line over time is a CF field of time and x") {
    const TemporaryFolder folder;
    const SpaceTime record{
        .title = "A wave", .time = {0.0, 1.0}, .x = {0.5, 1.5, 2.5}, .elevation = {1, 2, 3, 4, 5, 6}};
    write_space_time_nc(folder / "space_time.nc", record, test_provenance());
    const File file(folder / "space_time.nc");
    CHECK(file.values("eta", 6) == std::vector<double>{1, 2, 3, 4, 5, 6});
    CHECK(file.values("x", 3) == record.x);
    CHECK(file.text("x", "units") == "m");
}

TEST_CASE("equal records are equal bytes, and nothing is left of what could not be written") {
    const TemporaryFolder folder;
    write_gauges_nc(folder / "a.nc", two_gauges, test_provenance());
    write_gauges_nc(folder / "b.nc", two_gauges, test_provenance());
    CHECK(read_text(folder / "a.nc") == read_text(folder / "b.nc"));
    CHECK_THROWS_AS(write_gauges_nc(folder / "none" / "a.nc", two_gauges, test_provenance()), OutputError);
}

TEST_CASE("no gauges, no times: no file") {
    const TemporaryFolder folder;
    write_gauges_nc(folder / "gauges.nc", {.title = "t", .time = {1.0}, .stations = {}}, test_provenance());
    write_gauges_nc(folder / "gauges.nc", {.title = "t", .time = {}, .stations = {{"x=1", 1.0, 0.0, {}}}},
                    test_provenance());
    write_space_time_nc(folder / "gauges.nc", {}, test_provenance());
    CHECK(!std::filesystem::exists(folder / "gauges.nc"));
}
