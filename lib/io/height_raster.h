// A raster of heights in a file that GDAL reads: one band, where it lies, and windows of its pixels.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tidewater::io {

struct RasterFacts {
    std::string file;    // as given
    std::string driver;  // GDAL's short name: "GTiff", "AAIGrid", "netCDF", …
    std::string crs;     // name of its coordinate reference system; empty: it has none
    std::string unit;    // of heights, as the file says; empty: it says none, and they are metres
    int columns = 0, rows = 0;
    std::array<double, 4>
        extent{};  // least x and y, greatest x and y of its pixels' edges, in its own system
};

// Pixels from `column` and `row` on, row by row.
struct RasterWindow {
    int column = 0, row = 0, columns = 0, rows = 0;
    std::vector<double> heights;        // m, with the band's scale, offset and unit
    std::vector<std::uint8_t> missing;  // 1 where the file has no data, or no number

    std::size_t index(int at_column, int at_row) const {
        return static_cast<std::size_t>(at_row - row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(at_column - column);
    }
};

struct CloseDataset {
    void operator()(void* dataset) const;
};

// All members throw InputError: one line with the file, what is wrong and what to do.
class HeightRaster {
public:
    // A file, or a variable of one as "NETCDF:file:variable". It must have one band, a geotransform and
    // heights in m or feet.
    explicit HeightRaster(const std::string& path);

    const RasterFacts& facts() const { return facts_; }

    // Turns map coordinates (m) in the system `crs` ("EPSG:3413", WKT or PROJ text; empty: the raster's own)
    // into columns and rows, in which pixels' centres are whole numbers: GDAL places pixels as areas whether
    // the file's values belong to areas or to points. If the raster has no system of its own it is taken to
    // be in `crs`. The one in which the coordinates are must have metres.
    void to_pixels(const std::string& crs, std::vector<double>& x, std::vector<double>& y) const;

    // Whether to_pixels turns places from `crs` into another system of the raster's own.
    bool is_other_system(const std::string& crs) const;

    // The part of the window that the raster has.
    RasterWindow read(int column, int row, int columns, int rows) const;

private:
    std::unique_ptr<void, CloseDataset> dataset_;
    RasterFacts facts_;
    std::array<double, 6> to_map_{}, to_pixel_{};  // GDAL's geotransform and its inverse
    double metre_ = 1.0;                           // of the unit of heights
};

// Fills missing pixels from the rim of their holes: the inverse-distance mean of the nearest pixels in four
// directions, from all of the window (GDALFillNodata, in float). What it cannot reach stays missing.
void fill_missing(RasterWindow& window);

}  // namespace tidewater::io
