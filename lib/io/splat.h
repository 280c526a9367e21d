// Particles as discs, nearest to the viewer first, on a raster finer than the pixels. Parallel projection; no
// display.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "io/canvas.h"

namespace tidewater::io {

// Where a point p (m) is seen: pixel x = origin.x + scale p·right, y = origin.y - scale p·up; greater
// p·toward is nearer.
struct View {
    std::array<double, 3> right{1, 0, 0}, up{0, 0, 1}, toward{0, -1, 0};  // unit vectors, at right angles
    double scale = 1.0;                                                   // pixels per m
    Pixel origin;

    Pixel project(const std::array<double, 3>& point) const;
};

struct Raster {
    static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
    static constexpr int samples = 3;  // per pixel and axis

    int width, height;  // pixels
    std::vector<std::uint32_t>
        particle;              // index of what is seen at each sample, or `empty`; rows from the top down
    std::vector<float> depth;  // p·toward of the surface seen, m

    int columns() const { return width * samples; }
    int rows() const { return height * samples; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(column);
    }
    std::uint32_t at(int column, int row) const { return particle[index(column, row)]; }
};

// Draws particle p as a ball of `radius` m, and at least of three quarters of a sample, around points[3p ..
// 3p + 2]. Seen in the plane of the balls' centres, as in 2D, each sample thus goes to the particle nearest
// to it. Ties go to the lower index. Only the part that falls on width × height pixels counts. At most 2^32 -
// 2 particles.
Raster splat(std::span<const float> points, double radius, const View& view, int width, int height);

// How much light the surface at each sample reflects, 1 where it faces the light fully, from the slope of the
// depth averaged over `radius` m around; an empty sample has 1.
std::vector<float> shading(const Raster& raster, const View& view, double radius);

}  // namespace tidewater::io
