#include "io/surface_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/files.h"
#include "io/hdf5_file.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

Surface test_surface(std::size_t along, std::size_t across) {
    Surface surface{.time = 2.5, .still_level = 1.0, .x = {}, .y = {}, .bed = {}, .elevation = {}};
    for (std::size_t i = 0; i < along; ++i) surface.x.push_back(0.5 + static_cast<double>(i));
    for (std::size_t j = 0; j < across; ++j) surface.y.push_back(0.5 + static_cast<double>(j));
    for (std::size_t at = 0; at < along * across; ++at) {
        surface.bed.push_back(0.25f * static_cast<float>(at));
        surface.elevation.push_back(at == 1 ? std::numeric_limits<float>::quiet_NaN()
                                            : -0.5f * static_cast<float>(at));
    }
    return surface;
}

}  // namespace

TEST_CASE("a surface reads back as it was written: one place, a line and a field") {
    const TemporaryFolder folder;
    for (const auto& [along, across] : {std::pair{1, 1}, {40, 1}, {7, 5}}) {
        const Surface surface =
            test_surface(static_cast<std::size_t>(along), static_cast<std::size_t>(across));
        write_surface(folder / "surface_0000.h5", surface, test_provenance());
        const Surface read = read_surface(folder / "surface_0000.h5");
        CHECK(read.time == 2.5);
        CHECK(read.still_level == 1.0);
        CHECK(read.x == surface.x);
        CHECK(read.y == surface.y);
        CHECK(read.bed == surface.bed);
        CHECK(std::ranges::equal(read.elevation, surface.elevation, [](float a, float b) {
            return a == b || (std::isnan(a) && std::isnan(b));
        }));
    }
}

TEST_CASE("equal surfaces are equal bytes") {
    const TemporaryFolder folder;
    write_surface(folder / "a.h5", test_surface(9, 4), test_provenance());
    write_surface(folder / "b.h5", test_surface(9, 4), test_provenance());
    CHECK(read_text(folder / "a.h5") == read_text(folder / "b.h5"));
}

TEST_CASE("files that are missing, truncated or of a newer version are told") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(read_surface(folder / "surface_0000.h5"), InputError);
    write_surface(folder / "cut.h5", test_surface(900, 40), test_provenance());
    std::filesystem::resize_file(folder / "cut.h5", std::filesystem::file_size(folder / "cut.h5") - 100);
    CHECK_THROWS_AS(read_surface(folder / "cut.h5"), InputError);
    Hdf5Writer newer(folder / "newer.h5");
    newer.attribute("/", "format", "tidewater-surface");
    newer.attribute("/", "format_version", std::array{surface_format_version + 1});
    newer.close();
    CHECK_THROWS_WITH_AS(read_surface(folder / "newer.h5"),
                         doctest::Contains("its format version 2 is newer than this program's 1"),
                         InputError);
}

TEST_CASE("surfaces are named by their frame") {
    CHECK(surface_name(7) == "surface_0007.h5");
    CHECK(surface_name(12345) == "surface_12345.h5");
}
