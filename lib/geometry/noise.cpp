#include "geometry/noise.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/random.h"

namespace tidewater::geometry {
namespace {

// Lattice units per wavelength, and what brings the greatest sum to 1; both found numerically.
constexpr double plane_pitch = 1.382, space_pitch = 1.531;
constexpr double plane_scale = 99.204, space_scale = 76.880;

std::uint64_t corner_hash(std::uint64_t key, long i, long j, long k) {
    const auto bits = [](long n) { return static_cast<std::uint64_t>(n) & 0x1fffffULL; };
    return mix64(key ^ (bits(i) << 42 | bits(j) << 21 | bits(k)));
}

double kernel(double squared) {
    const double rest = 0.5 - squared;
    return rest > 0.0 ? rest * rest * rest * rest : 0.0;
}

// Any direction: from the tangent t of half an angle up to 45°, and one of eight mirrorings.
double corner(std::uint64_t hash, double x, double y) {
    const double share = kernel(x * x + y * y);
    if (share == 0.0) return 0.0;
    const double t = (std::numbers::sqrt2 - 1.0) * 0x1.0p-53 * static_cast<double>(hash >> 11);
    const double first = hash & 1 ? -x : x, second = hash & 2 ? -y : y;
    const double a = hash & 4 ? second : first, b = hash & 4 ? first : second;
    return share * ((1.0 - t * t) * a + 2.0 * t * b) / (1.0 + t * t);
}

// One of the twelve from a cube's centre to the middles of its edges.
double corner(std::uint64_t hash, double x, double y, double z) {
    const double share = kernel(x * x + y * y + z * z);
    if (share == 0.0) return 0.0;
    const double first = hash >> 63 ? -1.0 : 1.0, second = hash >> 62 & 1 ? -1.0 : 1.0;
    const auto zero = (hash & 0xffffffffULL) % 3;
    const double a = zero == 0 ? y : x, b = zero == 2 ? y : z;
    return share * (first * a + second * b);
}

}  // namespace

// A square lattice is skewed into one of equilateral triangles: of which cell (i, j), then of which half.
double simplex_noise(std::uint64_t seed, double x, double y) {
    constexpr double skew = 0.36602540378443865, unskew = 0.21132486540518712;  // (√3 − 1)/2, (3 − √3)/6
    x *= plane_pitch;
    y *= plane_pitch;
    const double skewed = skew * (x + y);
    const long i = static_cast<long>(std::floor(x + skewed)), j = static_cast<long>(std::floor(y + skewed));
    const double back = unskew * static_cast<double>(i + j);
    const double x0 = x - static_cast<double>(i) + back, y0 = y - static_cast<double>(j) + back;
    const long di = x0 > y0 ? 1 : 0;
    const std::uint64_t key = mix64(seed);
    const double middle =
        corner(corner_hash(key, i + di, j + 1 - di, 0), x0 - static_cast<double>(di) + unskew,
               y0 - static_cast<double>(1 - di) + unskew);
    return plane_scale *
           (corner(corner_hash(key, i, j, 0), x0, y0) + middle +
            corner(corner_hash(key, i + 1, j + 1, 0), x0 - 1.0 + 2.0 * unskew, y0 - 1.0 + 2.0 * unskew));
}

// The same with tetrahedra: from the cell's first corner to its last, along the axes by falling coordinate.
double simplex_noise(std::uint64_t seed, double x, double y, double z) {
    constexpr double skew = 1.0 / 3.0, unskew = 1.0 / 6.0;
    const std::array<double, 3> at{space_pitch * x, space_pitch * y, space_pitch * z};
    const double skewed = skew * (at[0] + at[1] + at[2]);
    std::array<long, 3> cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
        cell[axis] = static_cast<long>(std::floor(at[axis] + skewed));
    const double back = unskew * static_cast<double>(cell[0] + cell[1] + cell[2]);
    std::array<double, 3> d;
    for (std::size_t axis = 0; axis < 3; ++axis) d[axis] = at[axis] - static_cast<double>(cell[axis]) + back;
    std::array<std::size_t, 3> order{0, 1, 2};
    if (d[order[0]] < d[order[1]]) std::swap(order[0], order[1]);
    if (d[order[1]] < d[order[2]]) std::swap(order[1], order[2]);
    if (d[order[0]] < d[order[1]]) std::swap(order[0], order[1]);
    const std::uint64_t key = mix64(seed);
    double sum = corner(corner_hash(key, cell[0], cell[1], cell[2]), d[0], d[1], d[2]);
    for (const std::size_t axis : order) {
        ++cell[axis];
        d[axis] -= 1.0;
        for (double& component : d) component += unskew;
        sum += corner(corner_hash(key, cell[0], cell[1], cell[2]), d[0], d[1], d[2]);
    }
    return space_scale * sum;
}

}  // namespace tidewater::geometry
