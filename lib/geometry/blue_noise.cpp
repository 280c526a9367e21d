#include "geometry/blue_noise.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"

namespace tidewater::geometry {
namespace {

constexpr double reach = 1.3;
constexpr double push = 0.3;
constexpr int most_steps = 400;
constexpr std::uint64_t tile_stream = 0x626c7565ULL;

template <int D>
std::array<long, D> cell(long index, long edge) {
    std::array<long, D> result;
    for (int axis = D - 1; axis >= 0; --axis, index /= edge)
        result[static_cast<std::size_t>(axis)] = index % edge;
    return result;
}

template <int D>
struct Pushed {
    Vector<D, double> offset;
    double nearest;  // distance to the nearest other point
};

// Points of cells three apart are farther from each other than `reach`.
template <int D>
Pushed<D> push_apart(const BlueNoiseTile<D>& tile, long index) {
    const auto own = cell<D>(index, tile.edge);
    const Vector<D, double>& from = tile.offset[static_cast<std::size_t>(index)];
    Vector<D, double> sum = Vector<D, double>::Zero();
    double nearest = 2.0 * reach;
    constexpr long around = D == 2 ? 25 : 125;
    for (long n = 0; n < around; ++n) {
        if (n == around / 2) continue;  // itself
        auto other = cell<D>(n, 5);
        Vector<D, double> way = from;
        for (std::size_t axis = 0; axis < D; ++axis) {
            way[static_cast<long>(axis)] -= static_cast<double>(other[axis] - 2);
            other[axis] += own[axis] - 2;
        }
        way -= tile.at(other);
        const double distance = way.norm();
        nearest = std::min(nearest, distance);
        if (distance < reach && distance > 0.0) sum += (1.0 / distance - 1.0 / reach) * way;
    }
    return {(from + push * sum).cwiseMax(-most_offset).cwiseMin(most_offset), nearest};
}

}  // namespace

template <int D>
const Vector<D, double>& BlueNoiseTile<D>::at(const std::array<long, D>& lattice) const {
    long index = 0;
    for (const long n : lattice) index = index * edge + (n % edge + edge) % edge;
    return offset[static_cast<std::size_t>(index)];
}

template <int D>
BlueNoiseTile<D> make_blue_noise_tile(long edge, std::uint64_t seed) {
    assert(edge >= 5);
    std::size_t count = 1;
    for (int axis = 0; axis < D; ++axis) count *= static_cast<std::size_t>(edge);
    BlueNoiseTile<D> tile{edge, std::vector<Vector<D, double>>(count)};
    for (std::size_t n = 0; n < count; ++n) {
        for (int axis = 0; axis < D; ++axis) {
            const auto stream = tile_stream + static_cast<std::uint64_t>(axis);
            tile.offset[n][axis] = most_offset * (2.0 * random_uniform(seed, stream, n) - 1.0);
        }
    }
    std::vector<Pushed<D>> pushed(count);
    for (int step = 0; step < most_steps; ++step) {
        parallel_for(
            count, [&](std::size_t n) { pushed[n] = push_apart(tile, static_cast<long>(n)); }, 64);
        const auto nearest = std::min_element(
            pushed.begin(), pushed.end(), [](const auto& a, const auto& b) { return a.nearest < b.nearest; });
        if (nearest->nearest >= least_distance) break;
        for (std::size_t n = 0; n < count; ++n) tile.offset[n] = pushed[n].offset;
    }
    return tile;
}

template struct BlueNoiseTile<2>;
template struct BlueNoiseTile<3>;
template BlueNoiseTile<2> make_blue_noise_tile<2>(long, std::uint64_t);
template BlueNoiseTile<3> make_blue_noise_tile<3>(long, std::uint64_t);

}  // namespace tidewater::geometry
