#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "core/random.h"
#include "geometry/cracks.h"

namespace tidewater::geometry {
namespace {

constexpr std::uint64_t line_stream = 0x6c696e65ULL;

double measure(const CrackSettings& s) {
    const Point size = s.region.high - s.region.low;
    return size[0] * size[2] * (s.dimension == 3 ? size[1] : 1.0);
}

// Points per cell, from points evenly in the region.
struct Pieces {
    std::vector<std::uint32_t> points;
    double share = 0.0;  // of the region, of a point
};

Pieces count_pieces(const Cracks& cracks, const CrackFinder& finder) {
    const CrackSettings& s = cracks.settings;
    const Point size = s.region.high - s.region.low;
    const double step = s.cell_size / (s.dimension == 3 ? 8.0 : 16.0);
    std::array<std::size_t, 3> count{1, 1, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (s.dimension == 3 || axis != 1)
            count[axis] = std::max<std::size_t>(
                1, static_cast<std::size_t>(std::lround(size[static_cast<long>(axis)] / step)));
    }
    std::vector<std::atomic<std::uint32_t>> points(cracks.sites.size());
    parallel_for(count[0], [&](std::size_t x) {
        for (std::size_t y = 0; y < count[1]; ++y) {
            for (std::size_t z = 0; z < count[2]; ++z) {
                const auto along = [&](std::size_t n, std::size_t axis) {
                    const auto i = static_cast<long>(axis);
                    return s.region.low[i] +
                           size[i] * (static_cast<double>(n) + 0.5) / static_cast<double>(count[axis]);
                };
                points[finder.cell({along(x, 0), along(y, 1), along(z, 2)})] += 1;
            }
        }
    });
    return {{points.begin(), points.end()}, 1.0 / static_cast<double>(count[0] * count[1] * count[2])};
}

void measure_pieces(const Cracks& cracks, const CrackFinder& finder, CrackStatistics& result) {
    const int dimension = cracks.settings.dimension;
    const auto [points, share] = count_pieces(cracks, finder);
    std::vector<double> diameters;
    for (const std::uint32_t count : points) {
        if (count == 0) continue;
        const double volume = count * share * measure(cracks.settings);
        diameters.push_back(dimension == 3 ? std::cbrt(6.0 * volume / std::numbers::pi)
                                           : std::sqrt(4.0 * volume / std::numbers::pi));
    }
    result.pieces = diameters.size();
    double sum = 0.0, squares = 0.0;
    for (const double diameter : diameters) sum += diameter;
    result.diameter_mean = sum / static_cast<double>(diameters.size());
    for (const double diameter : diameters) squares += std::pow(diameter - result.diameter_mean, 2);
    result.diameter_deviation = std::sqrt(squares / static_cast<double>(diameters.size()));
    const auto [least, greatest] = std::minmax_element(diameters.begin(), diameters.end());
    result.diameter_least = *least;
    result.diameter_greatest = *greatest;
}

constexpr std::size_t lines = 250'000;

// Walls crossed per m of short lines, r/8, anywhere in the region in any direction.
double crossings(const Cracks& cracks, const CrackFinder& finder) {
    const CrackSettings& s = cracks.settings;
    const double length = 0.125 * s.cell_size;
    std::vector<int> crossed(lines);
    parallel_for(
        lines,
        [&](std::size_t n) {
            const auto u = [&](std::uint64_t stream) {
                return random_uniform(s.seed, line_stream + stream, n);
            };
            const Point middle =
                s.region.low + Point(u(0), u(1), u(2)).cwiseProduct(s.region.high - s.region.low);
            const double turn = 2.0 * std::numbers::pi * u(3);
            const double y = s.dimension == 3 ? 2.0 * u(4) - 1.0 : 0.0, level = std::sqrt(1.0 - y * y);
            const Point way = length * Point(level * std::cos(turn), y, level * std::sin(turn));
            crossed[n] = finder.walls_between(middle - 0.5 * way, middle + 0.5 * way);
        },
        256);
    double sum = 0.0;
    for (const int count : crossed) sum += count;
    return sum / (length * static_cast<double>(lines));
}

bool within(const CrackSettings& s, const Point& site) {
    for (int axis = 0; axis < 3; ++axis) {
        if (s.dimension == 2 && axis == 1) continue;
        if (site[axis] < s.region.low[axis] || site[axis] >= s.region.high[axis]) return false;
    }
    return true;
}

}  // namespace

CrackStatistics statistics(const Cracks& cracks, const CrackFinder& finder) {
    const CrackSettings& s = cracks.settings;
    CrackStatistics result;
    for (const Point& site : cracks.sites) result.cells += within(s, site);
    const double volume = measure(s);
    if (result.cells > 0)
        result.cell_size = std::pow(volume / static_cast<double>(result.cells), 1.0 / s.dimension);
    measure_pieces(cracks, finder, result);
    result.wall_density = (s.dimension == 3 ? 2.0 : 0.5 * std::numbers::pi) * crossings(cracks, finder);
    result.crack_volume = result.wall_density * s.width * volume;
    return result;
}

}  // namespace tidewater::geometry
