#include "mpm/binning.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <limits>

#include "core/error.h"
#include "core/random.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

std::vector<Vector<2, double>> scattered_points(std::size_t count) {
    std::vector<Vector<2, double>> points(count);
    for (std::size_t n = 0; n < count; ++n)
        points[n] = {5.0 * random_uniform(1, 0, n), 3.0 * random_uniform(1, 1, n)};
    return points;
}

}  // namespace

TEST_CASE("place and sort put every point into the block that contains it, where it was") {
    const auto points = scattered_points(1000);
    Grid<2, double> grid;
    grid.layout = Layout<2>(0.1, {50, 30});
    std::vector<Particles<2, double>> bodies(1);
    const auto block_of = place(grid.layout, points, 0, bodies[0]);
    sort_into_blocks<2, double>(grid, bodies, {block_of});
    REQUIRE(bodies[0].begin.back() == 1000);
    for (std::size_t slot = 0; slot < grid.particle_blocks.size(); ++slot) {
        const Index<2> block = grid.layout.block_at(grid.particle_blocks[slot]);
        for (std::size_t p = bodies[0].begin[slot]; p < bodies[0].begin[slot + 1]; ++p) {
            const auto& position = bodies[0].position[p];
            CHECK(position.minCoeff() >= 0.0);
            CHECK(position.maxCoeff() < 8.0);
            CHECK(
                (global_position<2, double>(grid.layout, block, position) - points[bodies[0].id[p]]).norm() <
                1e-13);
            const bool in_order = p == bodies[0].begin[slot] || bodies[0].id[p - 1] < bodies[0].id[p];
            CHECK(in_order);
        }
    }
}

TEST_CASE("follow keeps places when particles cross blocks, and refuses what left the tank") {
    Grid<2, double> grid;
    grid.layout = Layout<2>(0.1, {50, 30});
    std::vector<Particles<2, double>> bodies(1);
    const auto points = scattered_points(200);
    sort_into_blocks<2, double>(grid, bodies, {place(grid.layout, points, 0, bodies[0])});
    for (auto& position : bodies[0].position) position[0] += 0.45;
    const auto block_of = follow(grid, bodies[0]);
    sort_into_blocks<2, double>(grid, bodies, {block_of});
    for_each_particle(bodies[0], [&](std::size_t slot, std::size_t p) {
        const Index<2> block = grid.layout.block_at(grid.particle_blocks[slot]);
        const Vector<2, double> moved = points[bodies[0].id[p]] + Vector<2, double>(0.045, 0.0);
        if ((global_position<2, double>(grid.layout, block, bodies[0].position[p]) - moved).norm() > 1e-13) {
            FAIL_CHECK("particle moved");
        }
    });
    bodies[0].position[7][1] = -40.0;
    CHECK_THROWS_WITH_AS(follow(grid, bodies[0]), doctest::Contains("left the tank"), NumericsError);
    bodies[0].position[7][1] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(follow(grid, bodies[0]), NumericsError);
}

TEST_CASE("a body without particles sorts to empty blocks") {
    Grid<3, float> grid;
    grid.layout = Layout<3>(0.1, {5, 5, 5});
    std::vector<Particles<3, float>> bodies(2);
    std::vector<std::vector<int>> block_of{
        place(grid.layout, {Vector<3, double>(0.2, 0.2, 0.2)}, 0, bodies[0]), {}};
    sort_into_blocks<3, float>(grid, bodies, block_of);
    CHECK(bodies[0].begin == std::vector<std::uint32_t>{0, 1});
    CHECK(bodies[1].begin == std::vector<std::uint32_t>{0, 0});
    CHECK(grid.node_blocks.size() == 27);
}
