#include "io/elevation_file.h"

#include <cpl_error.h>
#include <doctest/doctest.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>

#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

using Surface = std::function<double(double east, double north)>;

// A raster of heights at the centres of its pixels; by default north up, from (500000, 7500000) on.
struct Model {
    std::string driver = "GTiff";
    int columns = 40, rows = 30, bands = 1;
    std::array<double, 6> to_map{500000.0, 10.0, 0.0, 7500300.0, 0.0, -10.0};
    std::string crs = "EPSG:32622";
    GDALDataType type = GDT_Float64;
    std::string unit = {};
    double scale = 1.0, offset = 0.0;
    double nodata = -9999.0;
    bool declares_nodata = true;
    std::function<bool(int column, int row)> hole = {};
    std::vector<std::string> options = {};
    bool lies_somewhere = true;
};

void write_raster(const std::filesystem::path& path, const Model& model, const Surface& height) {
    GDALAllRegister();
    CPLPushErrorHandler(CPLQuietErrorHandler);
    GDALDatasetH memory = GDALCreate(GDALGetDriverByName("MEM"), "", model.columns, model.rows, model.bands,
                                     model.type, nullptr);
    auto to_map = model.to_map;
    if (model.lies_somewhere) GDALSetGeoTransform(memory, to_map.data());
    if (!model.crs.empty()) {
        OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
        REQUIRE(OSRSetFromUserInput(system, model.crs.c_str()) == OGRERR_NONE);
        OSRSetAxisMappingStrategy(system, OAMS_TRADITIONAL_GIS_ORDER);
        GDALSetSpatialRef(memory, system);
        OSRRelease(system);
    }
    std::vector<double> values;
    for (int row = 0; row < model.rows; ++row) {
        for (int column = 0; column < model.columns; ++column) {
            const double c = column + 0.5, r = row + 0.5;
            const double z =
                height(to_map[0] + c * to_map[1] + r * to_map[2], to_map[3] + c * to_map[4] + r * to_map[5]);
            const bool hole = model.hole && model.hole(column, row);
            values.push_back(hole ? model.nodata : (z - model.offset) / model.scale);
        }
    }
    for (int n = 1; n <= model.bands; ++n) {
        GDALRasterBandH band = GDALGetRasterBand(memory, n);
        if (model.declares_nodata) GDALSetRasterNoDataValue(band, model.nodata);
        if (model.scale != 1.0) GDALSetRasterScale(band, model.scale);
        if (model.offset != 0.0) GDALSetRasterOffset(band, model.offset);
        if (!model.unit.empty()) GDALSetRasterUnitType(band, model.unit.c_str());
        REQUIRE(GDALRasterIO(band, GF_Write, 0, 0, model.columns, model.rows, values.data(), model.columns,
                             model.rows, GDT_Float64, 0, 0) == CE_None);
    }
    std::vector<char*> options;
    for (const auto& option : model.options) options.push_back(const_cast<char*>(option.c_str()));
    options.push_back(nullptr);
    GDALDatasetH file = GDALCreateCopy(GDALGetDriverByName(model.driver.c_str()), path.c_str(), memory, FALSE,
                                       options.data(), nullptr, nullptr);
    REQUIRE(file != nullptr);
    GDALClose(file);
    GDALClose(memory);
    CPLPopErrorHandler();
}

double plane(double east, double north) {
    return 100.0 + 0.2 * (east - 500000.0) - 0.1 * (north - 7500000.0);
}

double bowl(double east, double north) {
    const double dx = east - 500200.0, dy = north - 7500150.0;
    return 0.002 * dx * dx + 0.001 * dy * dy - 0.0015 * dx * dy;
}

const ElevationMap middle{.origin = {500100.0, 7500100.0}};

// The greatest difference from the surface at the places that the map's formula gives.
double greatest_error(const ElevationGrid& grid, const ElevationMap& map, const Surface& height) {
    const double azimuth = map.azimuth * std::numbers::pi / 180.0;
    double worst = 0.0;
    for (int i = 0; i < grid.nx; ++i) {
        for (int j = 0; j < grid.ny; ++j) {
            const double x = i * grid.spacing, y = j * grid.spacing;
            const double east = map.origin[0] + x * std::sin(azimuth) - y * std::cos(azimuth);
            const double north = map.origin[1] + x * std::cos(azimuth) + y * std::sin(azimuth);
            const double z = grid.heights[static_cast<std::size_t>(i * grid.ny + j)];
            worst = std::max(worst, std::abs(z - (height(east, north) - map.datum)));
        }
    }
    return worst;
}

std::string error_of(const std::filesystem::path& path, const ElevationMap& map = middle,
                     NodataRule rule = NodataRule::refuse) {
    return input_error([&] { read_elevation(path.string(), map, 5.0, 20, 10, rule); });
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a plane is sampled exactly in any direction, from any driver, with rows either way") {
    const TemporaryFolder folder;
    Model south_up;
    south_up.to_map = {500000.0, 10.0, 0.0, 7500000.0, 0.0, 10.0};
    Model turned;
    turned.to_map = {500150.0, 8.0, 6.0, 7500000.0, 6.0, -8.0};  // 10 m pixels, turned by 37°
    turned.columns = turned.rows = 40;
    turned.to_map[0] = 500000.0 - 80.0;
    turned.to_map[3] = 7500150.0;
    Model ascii{.driver = "AAIGrid"};
    ascii.type = GDT_Float32;
    int number = 0;
    for (const Model& model : {Model{}, south_up, turned, ascii, Model{.driver = "netCDF"}}) {
        const auto path =
            folder / ("plane" + std::to_string(number++) + (model.driver == "AAIGrid" ? ".asc" : ""));
        CAPTURE(model.driver);
        CAPTURE(number);
        write_raster(path, model, plane);
        for (const double azimuth : {90.0, 0.0, 33.0, 251.0}) {
            const ElevationMap map{{500180.0, 7500150.0}, azimuth, 12.5, {}};
            const ElevationGrid grid = read_elevation(path.string(), map, 4.0, 12, 9);
            CHECK(grid.heights.size() == 12 * 9);
            CHECK(greatest_error(grid, map, plane) < (model.driver == "AAIGrid" ? 2e-3 : 1e-9));
            CHECK(grid.report.driver == model.driver);
            CHECK(grid.report.pixel[0] == doctest::Approx(10.0));
            CHECK(grid.report.pixel[1] == doctest::Approx(10.0));
            CHECK(grid.report.samples == 1);
            CHECK(grid.report.nodata_points == 0);
            CHECK(contains(grid.report.crs, "UTM zone 22N"));
        }
    }
}

TEST_CASE("a paraboloid is sampled to second order, and along a line in 2D") {
    const TemporaryFolder folder;
    write_raster(folder / "bowl.tif", Model{}, bowl);
    const ElevationMap map{{500120.0, 7500060.0}, 57.0, 3.0, {}};
    const double bilinear =
        (0.002 + 0.001 + 0.0015) * 10.0 * 10.0 / 4.0;  // the bound of h²/8 · second derivatives
    CHECK(greatest_error(read_elevation((folder / "bowl.tif").string(), map, 5.0, 30, 10), map, bowl) <
          bilinear);
    const ElevationGrid line = read_elevation((folder / "bowl.tif").string(), map, 5.0, 30, 1);
    CHECK(line.heights.size() == 30);
    CHECK(greatest_error(line, map, bowl) < bilinear);
}

TEST_CASE("a raster finer than the lattice is averaged, so that what is finer leaves no trace") {
    const TemporaryFolder folder;
    Model model;
    model.columns = 400, model.rows = 300;
    model.to_map = {500000.0, 1.0, 0.0, 7500300.0, 0.0, -1.0};
    const auto path = (folder / "fine.tif").string();
    write_raster(path, model, [](double east, double north) {
        return plane(east, north) + (static_cast<int>(std::floor(east)) % 2 ? 5.0 : -5.0);
    });
    for (const double azimuth : {90.0, 180.0}) {
        const ElevationMap map{{500150.0, 7500150.0}, azimuth, 0.0, {}};
        const ElevationGrid grid = read_elevation(path, map, 10.0, 8, 8);
        CHECK(grid.report.samples == 10);
        CHECK(greatest_error(grid, map, plane) < 1e-6);
    }
    // What the lattice can show is left: the mean of the bowl over 10 m × 10 m is (0.002 + 0.001) 10²/12
    // higher.
    write_raster(path, model, bowl);
    const ElevationMap map{{500150.0, 7500150.0}, 90.0, 0.0, {}};
    const ElevationGrid grid = read_elevation(path, map, 10.0, 8, 8);
    CHECK(greatest_error(grid, map, [](double east, double north) {
              return bowl(east, north) + 0.003 * 100.0 / 12.0;
          }) < 0.001);
}

TEST_CASE("pixels that are points lie where the file says") {
    const TemporaryFolder folder;
    Model model;
    const auto path = (folder / "points.tif").string();
    write_raster(path, model, plane);
    GDALDatasetH file = GDALOpen(path.c_str(), GA_Update);
    GDALSetMetadataItem(file, "AREA_OR_POINT", "Point", nullptr);
    GDALClose(file);
    CHECK(greatest_error(read_elevation(path, middle, 5.0, 20, 10), middle, plane) < 1e-9);
    // An ASCII grid that names its first pixel's centre.
    write_text(
        folder / "centre.asc",
        "ncols 3\nnrows 2\nxllcenter 100\nyllcenter 50\ncellsize 10\nNODATA_value -9999\n4 5 6\n1 2 3\n");
    const ElevationMap map{{100.0, 50.0}, 90.0, 0.0, "EPSG:32622"};
    const ElevationGrid grid = read_elevation((folder / "centre.asc").string(), map, 10.0, 3, 2);
    CHECK(grid.heights == std::vector<double>{1, 4, 2, 5, 3, 6});
    CHECK(grid.report.crs.empty());
}

TEST_CASE("scale, offset and feet are taken into account") {
    const TemporaryFolder folder;
    Model model{.type = GDT_Int16, .scale = 0.01, .offset = 50.0, .nodata = -32768.0};
    write_raster(folder / "scaled.tif", model, plane);
    CHECK(greatest_error(read_elevation((folder / "scaled.tif").string(), middle, 5.0, 20, 10), middle,
                         plane) < 0.006);
    write_raster(folder / "feet.tif", Model{.unit = "ft"},
                 [](double east, double north) { return plane(east, north) / 0.3048; });
    CHECK(greatest_error(read_elevation((folder / "feet.tif").string(), middle, 5.0, 20, 10), middle, plane) <
          1e-9);
    write_raster(folder / "fathoms.tif", Model{.unit = "fathom"}, plane);
    CHECK(contains(error_of(folder / "fathoms.tif"), "its heights are in \"fathom\""));
}

TEST_CASE("a raster in degrees is read at the places of a given system in metres") {
    const TemporaryFolder folder;
    Model model{.columns = 200, .rows = 200, .crs = "EPSG:4326"};
    model.to_map = {-51.02, 2e-4, 0.0, 67.62, 0.0, -2e-4};
    const auto path = (folder / "degrees.tif").string();
    // 111 km a degree of latitude: a slope along north of 1 in 100, about.
    write_raster(path, model, [](double, double latitude) { return 1113.2 * (latitude - 67.6); });
    const ElevationMap map{{500000.0, 7499000.0}, 0.0, 0.0, "EPSG:32622"};  // on the zone's meridian, 51° W
    const ElevationGrid grid = read_elevation(path, map, 25.0, 20, 1);
    CHECK(grid.report.other_system);
    CHECK(grid.report.pixel[1] == doctest::Approx(22.3).epsilon(0.01));
    CHECK(grid.report.pixel[0] == doctest::Approx(8.5).epsilon(0.01));
    CHECK((grid.heights.back() - grid.heights.front()) / (19 * 25.0) == doctest::Approx(0.01).epsilon(0.01));
    CHECK(
        contains(error_of(path), "its coordinates are in degrees (WGS 84); give crs of a system in metres"));
    CHECK(contains(error_of(path, {{-51.0, 67.6}, 0.0, 0.0, "EPSG:4326"}), "has degrees, not metres"));
    CHECK(contains(error_of(path, {{0.0, 0.0}, 0.0, 0.0, "EPSG:nonsense"}),
                   "is no coordinate reference system"));
    CHECK(contains(describe(grid.report), "WGS 84 (places turned into it)"));
}

TEST_CASE("a variable of a NetCDF file is read by its name") {
    const TemporaryFolder folder;
    const auto path = (folder / "bed.nc").string();
    write_raster(path, Model{.driver = "netCDF"}, plane);
    for (const std::string& name : {"NETCDF:" + path + ":Band1", "NETCDF:\"" + path + "\":Band1"}) {
        CHECK(greatest_error(read_elevation(name, middle, 5.0, 20, 10), middle, plane) < 1e-9);
    }
    CHECK(contains(error_of("NETCDF:nowhere.nc:bed"), "the file does not exist"));
    write_raster(folder / "two.nc", Model{.driver = "netCDF", .bands = 2}, plane);
    const std::string line = error_of(folder / "two.nc");
    CHECK(contains(line, "holds several rasters; name one of them: NETCDF:"));
    CHECK(contains(line, ":Band1 or "));
}

TEST_CASE("what is no elevation model is told with its remedy") {
    const TemporaryFolder folder;
    CHECK(contains(error_of(folder / "none.tif"), "none.tif: the file does not exist"));
    write_text(folder / "text.tif", "no raster at all\n");
    CHECK(contains(error_of(folder / "text.tif"), "no raster that GDAL can read"));
    write_raster(folder / "rgb.tif", Model{.bands = 3}, plane);
    CHECK(contains(error_of(folder / "rgb.tif"), "has 3 bands"));
    CHECK(contains(error_of(folder / "rgb.tif"), "gdal_translate -b 1"));
    write_raster(folder / "nowhere.tif", Model{.lies_somewhere = false}, plane);
    CHECK(contains(error_of(folder / "nowhere.tif"), "does not say where its pixels lie"));
    write_raster(folder / "bare.tif", Model{.crs = ""}, plane);
    CHECK(contains(error_of(folder / "bare.tif"),
                   "has no coordinate reference system; put its .prj beside it"));
    ElevationMap named = middle;
    named.crs = "EPSG:32622";
    CHECK(greatest_error(read_elevation((folder / "bare.tif").string(), named, 5.0, 20, 10), named, plane) <
          1e-9);
    write_raster(folder / "feet.tif", Model{.crs = "EPSG:2225"}, plane);
    CHECK(contains(error_of(folder / "feet.tif"), "its coordinates are in US survey foot"));
    // Half of the file is gone.
    write_raster(folder / "cut.tif", Model{}, plane);
    std::filesystem::resize_file(folder / "cut.tif", std::filesystem::file_size(folder / "cut.tif") / 2);
    CHECK(contains(error_of(folder / "cut.tif"), "cut.tif: "));
}

TEST_CASE("a scene beyond the raster is told with both extents, one to its edges is read") {
    const TemporaryFolder folder;
    const auto path = folder / "plane.tif";
    write_raster(path, Model{}, plane);
    const std::string line = error_of(path, {{500350.0, 7500100.0}, 90.0, 0.0, {}});
    CHECK(contains(line, "the scene reaches beyond it"));
    CHECK(contains(line, "x 500350 to 500445, y 7500100 to 7500145"));
    CHECK(contains(line, "which span x 500000 to 500400, y 7500000 to 7500300"));
    CHECK(contains(error_of(path, {{499997.0, 7500100.0}, 90.0, 0.0, {}}), "columns -0.3 to"));
    const ElevationMap whole{{500000.0, 7500000.0}, 90.0, 0.0, {}};
    const ElevationGrid grid = read_elevation(path.string(), whole, 5.0, 81, 61);
    CHECK(grid.heights[30] == doctest::Approx(plane(500005.0, 7500150.0)));  // of the outermost centre
    CHECK(grid.report.extent == std::array<double, 4>{500000.0, 7500000.0, 500400.0, 7500300.0});
}

TEST_CASE("holes are refused with their number and place, or filled from their rim") {
    const TemporaryFolder folder;
    const auto path = folder / "hole.tif";
    Model model;
    model.hole = [](int column, int row) { return column >= 14 && column < 17 && row >= 15 && row < 20; };
    write_raster(path, model, plane);
    const std::string line = error_of(path);
    CHECK(contains(line, "no data at "));
    CHECK(contains(line, "the first at (500140.0, 7500100.0) on the map (scene x = 40 m, y = 0 m)"));
    CHECK(contains(line, "the largest hole is 50 m long"));
    CHECK(contains(line, "give nodata = \"fill\""));
    const ElevationGrid grid = read_elevation(path.string(), middle, 5.0, 20, 10, NodataRule::fill);
    CHECK(grid.report.nodata_points > 0);
    CHECK(grid.report.nodata_share == doctest::Approx(grid.report.nodata_points / 200.0));
    CHECK(grid.report.largest_hole == doctest::Approx(50.0));
    CHECK(greatest_error(grid, middle, plane) < 5.0);  // the hole's rim spans 8 m
    CHECK(contains(describe(grid.report), "filled from the rim of holes, the largest 50 m long"));
    const auto outside = read_elevation(path.string(), {{500250.0, 7500100.0}, 90.0, 0.0, {}}, 5.0, 20, 10);
    CHECK(outside.report.nodata_points == 0);
    // No number is no data; nothing but holes cannot be filled.
    model.declares_nodata = false;
    model.nodata = std::nan("");
    write_raster(path, model, plane);
    CHECK(contains(error_of(path), "the largest hole is 50 m long"));
    model.hole = [](int, int) { return true; };
    write_raster(path, model, plane);
    CHECK(contains(error_of(path, middle, NodataRule::fill), "with no rim around it"));
    // A value that nobody declared.
    model.nodata = -9999.0;
    write_raster(path, model, plane);
    CHECK(contains(error_of(path), "the elevation -9999 m at (500100.0, 7500100.0)"));
    CHECK(contains(error_of(path), "gdal_edit.py -a_nodata"));
}
