#include "geometry/blue_noise.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

template <int D>
std::array<long, D> cell(long index, long edge) {
    std::array<long, D> result;
    for (std::size_t axis = D; axis-- > 0; index /= edge) result[axis] = index % edge;
    return result;
}

// Distances between all pairs, around the seam too.
template <int D>
double least_of_all_pairs(const BlueNoiseTile<D>& tile) {
    std::vector<Vector<D, double>> points;
    for (std::size_t n = 0; n < tile.offset.size(); ++n) {
        const auto own = cell<D>(static_cast<long>(n), tile.edge);
        Vector<D, double> point = tile.offset[n];
        for (std::size_t axis = 0; axis < D; ++axis)
            point[static_cast<long>(axis)] += static_cast<double>(own[axis]);
        points.push_back(point);
    }
    const double edge = static_cast<double>(tile.edge);
    double least = edge;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            Vector<D, double> way = points[i] - points[j];
            for (double& component : way) component -= edge * std::round(component / edge);
            least = std::min(least, way.norm());
        }
    }
    return least;
}

// Spread (standard deviation) of the points within 1.2 edges of random places, weighted by 1 − (d/1.2)², over
// their mean: how uneven a density a grid would see.
template <int D>
double unevenness(const BlueNoiseTile<D>& tile) {
    double sum = 0.0, squares = 0.0;
    const std::uint64_t places = 5000;
    for (std::uint64_t n = 0; n < places; ++n) {
        std::array<long, D> middle;
        Vector<D, double> at;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const double u = static_cast<double>(tile.edge) * random_uniform(3, axis, n);
            middle[axis] = std::lround(u);
            at[static_cast<long>(axis)] = u - static_cast<double>(middle[axis]);
        }
        double weight = 0.0;
        for (long k = 0; k < (D == 2 ? 25 : 125); ++k) {
            auto other = cell<D>(k, 5);
            Vector<D, double> way = -at;
            for (std::size_t axis = 0; axis < D; ++axis) {
                way[static_cast<long>(axis)] += static_cast<double>(other[axis] - 2);
                other[axis] += middle[axis] - 2;
            }
            weight += std::max(0.0, 1.0 - (way + tile.at(other)).squaredNorm() / 1.44);
        }
        sum += weight;
        squares += weight * weight;
    }
    const double mean = sum / static_cast<double>(places);
    return std::sqrt(squares / static_cast<double>(places) - mean * mean) / mean;
}

template <int D>
void check_tile(long edge) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const auto tile = make_blue_noise_tile<D>(edge, seed);
        CHECK(tile.offset.size() == static_cast<std::size_t>(std::pow(edge, D)));
        CHECK(least_of_all_pairs(tile) >= least_distance);
        double greatest = 0.0, squares = 0.0;
        for (const auto& offset : tile.offset) {
            greatest = std::max(greatest, offset.cwiseAbs().maxCoeff());
            squares += offset.squaredNorm() / D;
        }
        CHECK(greatest <= most_offset);
        CHECK(std::sqrt(squares / static_cast<double>(tile.offset.size())) > 0.1);  // no lattice
        auto jittered = tile;
        for (std::size_t n = 0; n < tile.offset.size(); ++n) {
            for (std::size_t axis = 0; axis < D; ++axis)
                jittered.offset[n][static_cast<long>(axis)] = random_uniform(seed, 90 + axis, n) - 0.5;
        }
        MESSAGE(D, "D, unevenness ", unevenness(tile), " against ", unevenness(jittered), " of jitter 1");
        CHECK(unevenness(tile) < 0.5 * unevenness(jittered));
    }
}

}  // namespace

TEST_CASE("a tile's points keep apart, around the seam too, in cells of one each, and are even") {
    check_tile<2>(32);
    check_tile<3>(12);
    CHECK(least_of_all_pairs(make_blue_noise_tile<3>(6, 1)) >= least_distance);
    CHECK(least_of_all_pairs(make_blue_noise_tile<2>(16, 1)) >= least_distance);
}

TEST_CASE("a tile repeats, below zero too, depends on its seed and not on threads") {
    const auto tile = make_blue_noise_tile<3>(12, 4);
    CHECK(tile.at({1, 2, 3}) == tile.at({13, -10, 27}));
    CHECK(tile.at({0, 0, 0}) == tile.offset.front());
    CHECK(tile.at({-1, 11, 23}) == tile.offset.back());
    CHECK(make_blue_noise_tile<3>(12, 5).offset != tile.offset);
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        CHECK(make_blue_noise_tile<3>(12, 4).offset == tile.offset);
    }
}
