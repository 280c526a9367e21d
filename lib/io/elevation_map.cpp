#include "io/elevation_map.h"

#include <cmath>
#include <numbers>

namespace tidewater::io {

MapLattice::MapLattice(const HeightRaster& raster, const ElevationMap& map, double spacing, int nx, int ny)
    : map_(map), spacing_(spacing), nx_(nx), ny_(ny) {
    for (int i = 0; i <= nx; ++i) {
        for (int j = 0; j <= ny; ++j) {
            const auto [east, north] = on_map(i - 0.5, j - 0.5);
            columns_.push_back(east);
            rows_.push_back(north);
        }
    }
    raster.to_pixels(map.crs, columns_, rows_);
}

std::size_t MapLattice::corner(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(ny_ + 1) + static_cast<std::size_t>(j);
}

std::array<double, 2> MapLattice::on_map(double i, double j) const {
    const double azimuth = map_.azimuth * std::numbers::pi / 180.0;
    const double x = i * spacing_, y = j * spacing_;
    return {map_.origin[0] + x * std::sin(azimuth) - y * std::cos(azimuth),
            map_.origin[1] + x * std::cos(azimuth) + y * std::sin(azimuth)};
}

std::array<double, 2> MapLattice::in_raster(int i, int j, double s, double t) const {
    const auto mixed = [&](const std::vector<double>& at) {
        const double low = std::lerp(at[corner(i, j)], at[corner(i, j + 1)], t);
        const double high = std::lerp(at[corner(i + 1, j)], at[corner(i + 1, j + 1)], t);
        return std::lerp(low, high, s);
    };
    return {mixed(columns_), mixed(rows_)};
}

// From the inverse of d(column, row)/d(x, y).
std::array<double, 2> MapLattice::pixel_size() const {
    const int i = nx_ / 2, j = ny_ / 2;
    const auto [left_column, left_row] = in_raster(i, j, 0.0, 0.5);
    const auto [right_column, right_row] = in_raster(i, j, 1.0, 0.5);
    const auto [low_column, low_row] = in_raster(i, j, 0.5, 0.0);
    const auto [high_column, high_row] = in_raster(i, j, 0.5, 1.0);
    const double column_x = right_column - left_column, column_y = high_column - low_column;
    const double row_x = right_row - left_row, row_y = high_row - low_row;
    const double whole = std::abs(column_x * row_y - column_y * row_x);
    return {spacing_ * std::hypot(row_y, row_x) / whole, spacing_ * std::hypot(column_x, column_y) / whole};
}

}  // namespace tidewater::io
