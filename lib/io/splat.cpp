#include "io/splat.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace tidewater::io {
namespace {

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The ball around (x, y) in samples, at depth z in samples too.
void draw_ball(Raster& raster, std::uint32_t index, double x, double y, double z, double radius) {
    const int first_x = std::max(static_cast<int>(std::ceil(x - radius - 0.5)), 0);
    const int first_y = std::max(static_cast<int>(std::ceil(y - radius - 0.5)), 0);
    const int last_x = std::min(static_cast<int>(std::floor(x + radius - 0.5)), raster.columns() - 1);
    const int last_y = std::min(static_cast<int>(std::floor(y + radius - 0.5)), raster.rows() - 1);
    for (int j = first_y; j <= last_y; ++j) {
        for (int i = first_x; i <= last_x; ++i) {
            const double dx = i + 0.5 - x, dy = j + 0.5 - y, left = radius * radius - dx * dx - dy * dy;
            if (left < 0.0) continue;
            const auto depth = static_cast<float>(z + std::sqrt(left));
            const auto sample = static_cast<std::size_t>(j) * static_cast<std::size_t>(raster.columns()) +
                                static_cast<std::size_t>(i);
            if (raster.particle[sample] != Raster::empty && depth <= raster.depth[sample]) continue;
            raster.particle[sample] = index;
            raster.depth[sample] = depth;
        }
    }
}

// Mean over a window of 2 half + 1 non-empty samples along one axis; `stride` leads to the next sample of a
// line.
void average_lines(const Raster& raster, std::size_t lines, std::size_t line_stride, std::size_t length,
                   std::size_t stride, std::size_t half, std::vector<float>& depth) {
    std::vector<double> sum(length + 1), count(length + 1);
    for (std::size_t line = 0; line < lines; ++line) {
        const std::size_t start = line * line_stride;
        for (std::size_t i = 0; i < length; ++i) {
            const bool seen = raster.particle[start + i * stride] != Raster::empty;
            sum[i + 1] = sum[i] + (seen ? static_cast<double>(depth[start + i * stride]) : 0.0);
            count[i + 1] = count[i] + (seen ? 1.0 : 0.0);
        }
        for (std::size_t i = 0; i < length; ++i) {
            const std::size_t first = i > half ? i - half : 0, end = std::min(i + half + 1, length);
            const double seen = count[end] - count[first];
            if (seen > 0.0) depth[start + i * stride] = static_cast<float>((sum[end] - sum[first]) / seen);
        }
    }
}

}  // namespace

Pixel View::project(const std::array<double, 3>& point) const {
    return {origin.x + scale * dot(point, right), origin.y - scale * dot(point, up)};
}

Raster splat(std::span<const float> points, double radius, const View& view, int width, int height) {
    assert(points.size() / 3 < Raster::empty);
    Raster raster{width, height, {}, {}};
    const auto samples = static_cast<std::size_t>(raster.columns()) * static_cast<std::size_t>(raster.rows());
    raster.particle.assign(samples, Raster::empty);
    raster.depth.assign(samples, 0.0f);
    const double fine = view.scale * Raster::samples, ball = std::max(radius * fine, 0.75);
    for (std::size_t p = 0; p < points.size() / 3; ++p) {
        const std::array<double, 3> point{points[3 * p], points[3 * p + 1], points[3 * p + 2]};
        const Pixel pixel = view.project(point);
        draw_ball(raster, static_cast<std::uint32_t>(p), pixel.x * Raster::samples, pixel.y * Raster::samples,
                  fine * dot(point, view.toward), ball);
    }
    for (float& depth : raster.depth) depth = static_cast<float>(depth / fine);
    return raster;
}

std::vector<float> shading(const Raster& raster, const View& view, double radius) {
    const auto columns = static_cast<std::size_t>(raster.columns()),
               rows = static_cast<std::size_t>(raster.rows());
    const double fine = view.scale * Raster::samples;
    const auto half = static_cast<std::size_t>(std::max(std::lround(radius * fine), 1L));
    std::vector<float> depth = raster.depth;
    for (int pass = 0; pass < 2; ++pass) {  // two boxes make a tent
        average_lines(raster, rows, columns, columns, 1, half, depth);
        average_lines(raster, columns, 1, rows, columns, half, depth);
    }

    // The light comes from the upper left behind the viewer: (right, up, toward) = (-0.37, 0.62, 0.69).
    std::vector<float> light(depth.size(), 1.0f);
    for (std::size_t j = 1; j + 1 < rows; ++j) {
        for (std::size_t i = 1; i + 1 < columns; ++i) {
            const std::size_t s = j * columns + i;
            if (raster.particle[s] == Raster::empty) continue;
            const auto slope = [&](std::size_t before, std::size_t after) {
                const bool seen =
                    raster.particle[before] != Raster::empty && raster.particle[after] != Raster::empty;
                return seen ? 0.5 * fine * (depth[after] - depth[before]) : 0.0;
            };
            const double to_right = slope(s - 1, s + 1), to_up = slope(s + columns, s - columns);
            const double length = std::sqrt(1.0 + to_right * to_right + to_up * to_up);
            light[s] = static_cast<float>(std::max(0.37 * to_right - 0.62 * to_up + 0.69, 0.0) / length);
        }
    }
    return light;
}

}  // namespace tidewater::io
