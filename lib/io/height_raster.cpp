#include "io/height_raster.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <gdal_alg.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "core/error.h"

namespace tidewater::io {
namespace {

// Keeps GDAL and PROJ from printing: what goes wrong is told by our own lines.
class Quiet {
public:
    Quiet() {
        CPLErrorReset();
        CPLPushErrorHandler(CPLQuietErrorHandler);
    }
    ~Quiet() { CPLPopErrorHandler(); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

    std::string message() const {
        const std::string text = CPLGetLastErrorMsg();
        return text.empty() ? "" : " (" + text.substr(0, text.find('\n')) + ")";
    }
};

struct Release {
    void operator()(void* system) const { OSRRelease(system); }
};
using System = std::unique_ptr<void, Release>;

struct Destroy {
    void operator()(void* transformation) const { OCTDestroyCoordinateTransformation(transformation); }
};

[[noreturn]] void fail(const std::string& file, const std::string& problem) {
    throw InputError(file + ": " + problem);
}

// The file's part of the path: "NETCDF:file:variable" and 'NETCDF:"file":variable' have more.
std::string file_of(const std::string& path) {
    const auto colon = path.find(':');
    if (colon == std::string::npos || (path.compare(0, colon, "NETCDF") != 0)) return path;
    std::string rest = path.substr(colon + 1);
    if (rest.starts_with('"')) return rest.substr(1, rest.find('"', 1) - 1);
    return rest.substr(0, rest.rfind(':'));
}

// "NETCDF:\"a.nc\":bed or …" if the file holds several rasters.
std::string rasters_in(GDALDatasetH dataset) {
    std::string names;
    char** list = GDALGetMetadata(dataset, "SUBDATASETS");
    for (int n = 1;; ++n) {
        const char* name = CSLFetchNameValue(list, ("SUBDATASET_" + std::to_string(n) + "_NAME").c_str());
        if (name == nullptr) return names;
        names += (n > 1 ? " or " : "") + std::string(name);
    }
}

GDALDatasetH open_raster(const std::string& path) {
    const std::string file = file_of(path);
    std::error_code error;
    if (!std::filesystem::exists(file, error)) fail(path, "the file does not exist; check the path");
    GDALAllRegister();
    const Quiet quiet;
    GDALDatasetH dataset =
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
    if (dataset != nullptr) return dataset;
    fail(path, "no raster that GDAL can read" + quiet.message() +
                   "; give a GeoTIFF, an ASCII grid (.asc) or a NetCDF file");
}

void check_bands(const std::string& path, GDALDatasetH dataset) {
    const int bands = GDALGetRasterCount(dataset);
    if (bands == 1) return;
    const std::string rasters = rasters_in(dataset);
    if (bands == 0 && !rasters.empty()) fail(path, "holds several rasters; name one of them: " + rasters);
    fail(path,
         "has " + std::to_string(bands) +
             " bands, and which one holds the heights is not known; take it out, say with gdal_translate -b "
             "1 " +
             path + " heights.tif");
}

// Metres in one of the unit; 0: unknown.
double metres_of(std::string unit) {
    std::ranges::transform(unit, unit.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, unit) != names.end();
    };
    if (is_one_of({"", "m", "metre", "metres", "meter", "meters"})) return 1.0;
    if (is_one_of({"ft", "foot", "feet", "international foot"})) return 0.3048;
    if (is_one_of({"us survey foot", "us-ft", "ftus", "foot_us", "sfoot"})) return 1200.0 / 3937.0;
    return 0.0;
}

System system_of(GDALDatasetH dataset) {
    OGRSpatialReferenceH own = GDALGetSpatialRef(dataset);
    System system(own != nullptr ? OSRClone(own) : nullptr);
    if (system) OSRSetAxisMappingStrategy(system.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

System named_system(const std::string& file, const std::string& crs) {
    System system(OSRNewSpatialReference(nullptr));
    const bool web = crs.starts_with("http:") || crs.starts_with("https:");
    if (web || OSRSetFromUserInput(system.get(), crs.c_str()) != OGRERR_NONE) {
        fail(file, "crs \"" + crs + "\" is no coordinate reference system; give one as \"EPSG:3413\"");
    }
    OSRSetAxisMappingStrategy(system.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

// What the system measures in, if that is not metres.
std::string other_unit(OGRSpatialReferenceH system) {
    if (OSRIsGeographic(system)) return "degrees";
    char* name = nullptr;
    const double metres = OSRGetLinearUnits(system, &name);
    return std::abs(metres - 1.0) < 1e-9 ? "" : std::string(name != nullptr ? name : "an unknown unit");
}

std::string name_of(OGRSpatialReferenceH system) {
    const char* name = OSRGetName(system);
    return name != nullptr && *name != '\0' ? name : "unnamed";
}

std::array<double, 4> extent_of(const std::array<double, 6>& to_map, int columns, int rows) {
    constexpr double far = 1e300;
    std::array<double, 4> extent{far, far, -far, -far};
    for (const int column : {0, columns}) {
        for (const int row : {0, rows}) {
            const double x = to_map[0] + column * to_map[1] + row * to_map[2];
            const double y = to_map[3] + column * to_map[4] + row * to_map[5];
            extent = {std::min(extent[0], x), std::min(extent[1], y), std::max(extent[2], x),
                      std::max(extent[3], y)};
        }
    }
    return extent;
}

}  // namespace

void CloseDataset::operator()(void* dataset) const { GDALClose(dataset); }

HeightRaster::HeightRaster(const std::string& path) : dataset_(open_raster(path)) {
    const Quiet quiet;
    check_bands(path, dataset_.get());
    facts_.file = path;
    facts_.driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset_.get()));
    facts_.columns = GDALGetRasterXSize(dataset_.get());
    facts_.rows = GDALGetRasterYSize(dataset_.get());
    if (GDALGetGeoTransform(dataset_.get(), to_map_.data()) != CE_None ||
        GDALInvGeoTransform(to_map_.data(), to_pixel_.data()) == 0) {
        fail(path,
             "does not say where its pixels lie; add that, say with gdal_translate -a_ullr and -a_srs, or "
             "take "
             "the original file");
    }
    facts_.extent = extent_of(to_map_, facts_.columns, facts_.rows);
    if (const System system = system_of(dataset_.get())) facts_.crs = name_of(system.get());
    const char* unit = GDALGetRasterUnitType(GDALGetRasterBand(dataset_.get(), 1));
    facts_.unit = unit != nullptr ? unit : "";
    metre_ = metres_of(facts_.unit);
    if (metre_ == 0.0) {
        fail(path, "its heights are in \"" + facts_.unit +
                       "\"; convert them to metres, say with gdal_translate "
                       "-scale or gdal_calc.py, and set the band's unit to m");
    }
}

void HeightRaster::to_pixels(const std::string& crs, std::vector<double>& x, std::vector<double>& y) const {
    const Quiet quiet;
    const std::string& file = facts_.file;
    const System own = system_of(dataset_.get());
    const std::string give = "give crs of a system in metres, as crs = \"EPSG:3413\"";
    if (!own && crs.empty()) {
        fail(file, "has no coordinate reference system; put its .prj beside it or " + give);
    }
    const System given = crs.empty() ? nullptr : named_system(file, crs);
    if (const std::string unit = other_unit(given ? given.get() : own.get()); !unit.empty()) {
        fail(file, given ? "crs \"" + crs + "\" has " + unit + ", not metres; " + give
                         : "its coordinates are in " + unit + " (" + facts_.crs + "); " + give);
    }
    if (is_other_system(crs)) {
        const std::unique_ptr<void, Destroy> transformation(
            OCTNewCoordinateTransformation(given.get(), own.get()));
        const auto count = static_cast<int>(x.size());
        if (!transformation || !OCTTransform(transformation.get(), count, x.data(), y.data(), nullptr)) {
            fail(file, "places in crs \"" + crs + "\" cannot be turned into its own system, " + facts_.crs +
                           quiet.message() + "; check origin and crs");
        }
    }
    for (std::size_t n = 0; n < x.size(); ++n) {
        // From the corner, so that large coordinates cost no digits.
        const double dx = x[n] - to_map_[0], dy = y[n] - to_map_[3];
        x[n] = to_pixel_[1] * dx + to_pixel_[2] * dy - 0.5;
        y[n] = to_pixel_[4] * dx + to_pixel_[5] * dy - 0.5;
    }
}

bool HeightRaster::is_other_system(const std::string& crs) const {
    const Quiet quiet;
    const System own = system_of(dataset_.get());
    return own && !crs.empty() && !OSRIsSame(own.get(), named_system(facts_.file, crs).get());
}

RasterWindow HeightRaster::read(int column, int row, int columns, int rows) const {
    const Quiet quiet;
    RasterWindow window;
    window.column = std::clamp(column, 0, facts_.columns);
    window.row = std::clamp(row, 0, facts_.rows);
    window.columns = std::clamp(column + columns, window.column, facts_.columns) - window.column;
    window.rows = std::clamp(row + rows, window.row, facts_.rows) - window.row;
    const std::size_t count =
        static_cast<std::size_t>(window.columns) * static_cast<std::size_t>(window.rows);
    window.heights.resize(count);
    std::vector<std::uint8_t> valid(count);
    window.missing.resize(count);
    if (count == 0) return window;
    GDALRasterBandH band = GDALGetRasterBand(dataset_.get(), 1);
    const auto read_into = [&](GDALRasterBandH from, void* values, GDALDataType type) {
        if (GDALRasterIO(from, GF_Read, window.column, window.row, window.columns, window.rows, values,
                         window.columns, window.rows, type, 0, 0) == CE_None)
            return;
        fail(facts_.file, "cannot be read" + quiet.message() + "; copy or download the file again");
    };
    read_into(band, window.heights.data(), GDT_Float64);
    read_into(GDALGetMaskBand(band), valid.data(), GDT_Byte);
    int has_scale = 0, has_offset = 0;
    const double scale = GDALGetRasterScale(band, &has_scale),
                 offset = GDALGetRasterOffset(band, &has_offset);
    for (std::size_t n = 0; n < count; ++n) {
        double& height = window.heights[n];
        height = metre_ * ((has_scale ? scale * height : height) + (has_offset ? offset : 0.0));
        window.missing[n] = valid[n] == 0 || !std::isfinite(height);
    }
    return window;
}

void fill_missing(RasterWindow& window) {
    const Quiet quiet;
    GDALAllRegister();
    const int columns = window.columns, rows = window.rows;
    std::vector<float> heights(window.heights.size());
    std::vector<std::uint8_t> valid(window.missing.size());
    constexpr float unfilled = -1e30f;
    for (std::size_t n = 0; n < heights.size(); ++n) {
        valid[n] = window.missing[n] ? 0 : 255;
        heights[n] = window.missing[n] ? unfilled : static_cast<float>(window.heights[n]);
    }
    const std::unique_ptr<void, CloseDataset> work(
        GDALCreate(GDALGetDriverByName("MEM"), "", columns, rows, 2, GDT_Float32, nullptr));
    GDALRasterBandH values = GDALGetRasterBand(work.get(), 1), mask = GDALGetRasterBand(work.get(), 2);
    char** options = CSLSetNameValue(nullptr, "TEMP_FILE_DRIVER", "MEM");
    const auto copy = [&](GDALRasterBandH band, GDALRWFlag way, void* memory, GDALDataType type) {
        return GDALRasterIO(band, way, 0, 0, columns, rows, memory, columns, rows, type, 0, 0) == CE_None;
    };
    const bool filled =
        copy(values, GF_Write, heights.data(), GDT_Float32) && copy(mask, GF_Write, valid.data(), GDT_Byte) &&
        GDALFillNodata(values, mask, std::max(columns, rows), 0, 0, options, nullptr, nullptr) == CE_None &&
        copy(values, GF_Read, heights.data(), GDT_Float32);
    CSLDestroy(options);
    for (std::size_t n = 0; filled && n < heights.size(); ++n) {
        if (!window.missing[n] || heights[n] <= unfilled) continue;
        window.heights[n] = static_cast<double>(heights[n]);
        window.missing[n] = 0;
    }
}

}  // namespace tidewater::io
