#include "geometry/cracks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

CrackSettings block(int dimension, double r, const Point& size) {
    CrackSettings settings{.cell_size = r, .dimension = dimension, .seed = 5};
    settings.region = {Point::Zero(), dimension == 2 ? Point(size[0], 0.0, size[2]) : size};
    return settings;
}

Point random_place(const CrackSettings& s, std::uint64_t n) {
    const auto u = [&](std::uint64_t axis) { return random_uniform(12, axis, n); };
    return s.region.low + Point(u(0), u(1), u(2)).cwiseProduct(s.region.high - s.region.low);
}

// By the definition, over all sites.
double wall_by_all(const Cracks& cracks, const Point& p) {
    const auto nearest = std::min_element(
        cracks.sites.begin(), cracks.sites.end(),
        [&](const Point& a, const Point& b) { return (a - p).squaredNorm() < (b - p).squaredNorm(); });
    double wall = std::numeric_limits<double>::infinity();
    for (const Point& site : cracks.sites) {
        if (&site == &*nearest) continue;
        wall = std::min(wall, ((site - p).squaredNorm() - (*nearest - p).squaredNorm()) /
                                  (2.0 * (site - *nearest).norm()));
    }
    return wall;
}

// Share of the region, by points `spacing` apart, that is nearer to a wall than half of each width.
std::vector<double> crack_shares(const CrackSettings& s, const CrackFinder& finder, double spacing,
                                 const std::vector<double>& widths) {
    const Point size = s.region.high - s.region.low;
    const auto count = [&](int axis) {
        return static_cast<std::size_t>(std::max(1L, std::lround(size[axis] / spacing)));
    };
    std::vector<std::vector<std::size_t>> hits(count(0), std::vector<std::size_t>(widths.size()));
    parallel_for(count(0), [&](std::size_t x) {
        for (std::size_t y = 0; y < count(1); ++y) {
            for (std::size_t z = 0; z < count(2); ++z) {
                const Point cell(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
                const double wall = finder.wall_distance(spacing * (cell + Point::Constant(0.5)));
                for (std::size_t w = 0; w < widths.size(); ++w) hits[x][w] += wall < 0.5 * widths[w];
            }
        }
    });
    std::vector<double> shares(widths.size());
    for (std::size_t w = 0; w < widths.size(); ++w) {
        for (const auto& slice : hits) shares[w] += static_cast<double>(slice[w]);
        shares[w] /= static_cast<double>(count(0) * count(1) * count(2));
    }
    return shares;
}

}  // namespace

TEST_CASE("the distance to the nearest wall is that of the definition over all sites") {
    for (const int dimension : {2, 3}) {
        const Cracks cracks = make_cracks(block(dimension, 30.0, {120.0, 90.0, 60.0}));
        const CrackFinder finder(cracks);
        double worst = 0.0;
        for (std::uint64_t n = 0; n < 20'000; ++n) {
            const Point p = random_place(cracks.settings, n);
            worst = std::max(worst, std::abs(finder.wall_distance(p) - wall_by_all(cracks, p)));
            const Point& own = cracks.sites[finder.cell(p)];
            for (const Point& site : cracks.sites)
                worst = std::max(worst, (own - p).norm() - (site - p).norm());
        }
        CHECK(worst < 1e-9);
    }
}

TEST_CASE("a larger region has the same cracks, on any number of threads, and another seed others") {
    const CrackSettings small = block(3, 40.0, {100.0, 120.0, 50.0});
    CrackSettings large = small, other = small;
    large.region = {Point(-300.0, -100.0, -200.0), Point(400.0, 300.0, 250.0)};
    other.seed = 6;
    const CrackFinder a(make_cracks(small)), c(make_cracks(other));
    const ThreadLimit limit(1);
    const CrackFinder b(make_cracks(large));
    int same = 0;
    for (std::uint64_t n = 0; n < 5000; ++n) {
        const Point p = random_place(small, n);
        CHECK(a.wall_distance(p) == b.wall_distance(p));
        same += a.wall_distance(p) == c.wall_distance(p);
    }
    CHECK(same == 0);
}

TEST_CASE("cells have the size asked for, and walls the area of a tessellation between cubes and Poisson's") {
    for (const int dimension : {2, 3}) {
        const Cracks cracks = make_cracks(block(dimension, 30.0, {301.0, 287.0, 155.0}));
        const CrackFinder finder(cracks);
        const CrackStatistics found = statistics(cracks, finder);
        CHECK(found.cell_size == doctest::Approx(30.0).epsilon(0.1));
        CHECK(found.pieces > found.cells);  // those of sites outside too
        CHECK(found.diameter_mean > 0.7 * 30.0);
        CHECK(found.diameter_mean < 1.24 * 30.0);  // (6/π)^(1/3), all whole and of one size
        CHECK(found.diameter_deviation > 0.1 * found.diameter_mean);
        CHECK(found.diameter_greatest < 2.0 * 30.0);
        // Poisson's: 2.910/r in space and 2/r in the plane (Okabe et al. 2000); cubes 3/r, squares 2/r.
        CHECK(found.wall_density * 30.0 > (dimension == 3 ? 2.8 : 1.9));
        CHECK(found.wall_density * 30.0 < (dimension == 3 ? 3.0 : 2.05));
        const ThreadLimit limit(1);
        CHECK(statistics(cracks, finder).wall_density == found.wall_density);
    }
}

TEST_CASE("cracks far thinner than the particles' spacing keep their volume") {
    const CrackSettings settings = block(3, 80.0, {480.0, 480.0, 150.0});
    const Cracks cracks = make_cracks(settings);
    const CrackFinder finder(cracks);
    const double density = statistics(cracks, finder).wall_density;
    const std::vector<double> widths{0.5, 1.0, 2.0};
    const auto shares = crack_shares(settings, finder, 2.5, widths);
    for (std::size_t w = 0; w < widths.size(); ++w) {
        MESSAGE("width ", widths[w], ": share ", shares[w], " of ", density * widths[w]);
        CHECK(std::abs(shares[w] / (density * widths[w]) - 1.0) < 0.05);
    }
    const CrackSettings flat = block(2, 80.0, {2000.0, 0.0, 2000.0});
    const Cracks lines = make_cracks(flat);
    const CrackFinder line_finder(lines);
    const double share = crack_shares(flat, line_finder, 2.5, {1.0}).front();
    const CrackStatistics found = statistics(lines, line_finder);
    CHECK(std::abs(share / found.wall_density - 1.0) < 0.05);
    CHECK(std::abs(share * 4e6 / found.crack_volume - 1.0) < 0.05);
}

TEST_CASE("cracks that leave no cells are refused") {
    CrackSettings bad = block(3, 30.0, {100.0, 100.0, 100.0});
    bad.width = 8.0;
    CHECK_THROWS_WITH_AS(make_cracks(bad), doctest::Contains("below a quarter of cell_size"), SceneError);
    bad = block(3, 0.0, {100.0, 100.0, 100.0});
    CHECK_THROWS_WITH_AS(make_cracks(bad), doctest::Contains("cell_size must be above 0"), SceneError);
    bad = block(3, 30.0, {100.0, 100.0, 100.0});
    bad.cohesion = 1.5;
    CHECK_THROWS_WITH_AS(make_cracks(bad), doctest::Contains("cohesion"), SceneError);
}
