#include "mpm/particles/binning.h"

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

template <class Real>
struct Placed {
    Grid<2, Real> grid;
    std::vector<Particles<2, Real>> bodies{1};
    std::vector<Vector<2, double>> points;

    explicit Placed(std::size_t count) : points(scattered_points(count)) {
        grid.layout = Layout<2>{0.1, {50, 30}};
        place<2, Real>({points}, grid, bodies);
    }
    void sort() { sort_into_blocks<2, Real>(grid, bodies); }
};

}  // namespace

TEST_CASE_TEMPLATE("place puts every point into the block that contains it, where it was", Real, float,
                   double) {
    const ThreadLimit serial(1);
    const Placed<Real> s(1000);
    const auto& particles = s.bodies[0];
    REQUIRE(particles.begin.back() == 1000);
    CHECK(std::is_sorted(s.grid.particle_blocks.begin(), s.grid.particle_blocks.end()));
    for_each_particle(s.grid, particles, [&](std::size_t slot, const Index<2>& block, std::size_t p) {
        const Vector<2, double> local = local_position(particles, p);
        CHECK(local.minCoeff() >= 0.0);
        CHECK(local.maxCoeff() <= Block<2>::width);  // a float may have been rounded up to the end
        const Vector<2, double> error =
            global_position(s.grid.layout, block, particles, p) - s.points[particles.id[p]];
        CHECK(error.norm() < (sizeof(Real) == 4 ? 1.1e-9 : 1e-13));  // m; half a unit is 7.5e-10 m per axis
        const bool in_order = p == particles.begin[slot] || particles.id[p - 1] < particles.id[p];
        CHECK(in_order);
    });
}

TEST_CASE_TEMPLATE("sorting keeps places when particles cross blocks", Real, float, double) {
    const ThreadLimit serial(1);
    Placed<Real> s(200);
    auto& particles = s.bodies[0];
    for (std::uint32_t id : particles.id) particles.j.push_back(static_cast<Real>(id));  // sorted along
    const auto before = particles.begin;
    for (auto& x : particles.position[0]) x += stored<Real>(7.5);
    for (auto& point : s.points) point[0] += 0.75;
    s.grid.layout.cells[0] = 60;
    s.sort();
    CHECK(particles.begin != before);
    REQUIRE(particles.begin.back() == 200);
    for_each_particle(s.grid, particles, [&](std::size_t, const Index<2>& block, std::size_t p) {
        const auto local = local_position(particles, p);
        CHECK(local.minCoeff() >= 0.0);
        CHECK(local.maxCoeff() < Block<2>::width);
        const Vector<2, double> error =
            global_position(s.grid.layout, block, particles, p) - s.points[particles.id[p]];
        CHECK(error.norm() < (sizeof(Real) == 4 ? 1.1e-9 : 1e-13));
        CHECK(particles.j[p] == static_cast<Real>(particles.id[p]));
    });
}

TEST_CASE("sorting refuses what left the tank and what is not a number") {
    Placed<double> s(200);
    auto& z = s.bodies[0].position[1];
    z[7] = -40.0;
    CHECK_THROWS_WITH_AS(s.sort(), doctest::Contains("left the tank"), NumericsError);
    z[7] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(s.sort(), NumericsError);
}

TEST_CASE("sorting keeps the nodes of blocks that stay and gives others zero") {
    Grid<2, double> grid;
    grid.layout = Layout<2>{1.0, {160, 16}};
    std::vector<Particles<2, double>> bodies(1);
    const std::vector<Vector<2, double>> points{{8.0, 8.0}};
    place<2, double>({points}, grid, bodies);
    for (std::size_t n = 0; n < grid.nodes.size(); ++n)
        grid.nodes[n] = Node<double>::Constant(static_cast<double>(grid.node_blocks[n / Block<2>::nodes]));
    bodies[0].position[0][0] += Block<2>::width;
    sort_into_blocks<2, double>(grid, bodies);
    CHECK(block_at<2>(grid.particle_blocks[0]) == Index<2>{3, 2});
    for (std::size_t slot = 0; slot < grid.node_blocks.size(); ++slot) {
        const bool old = block_at<2>(grid.node_blocks[slot])[0] <= 3;
        const double value = old ? static_cast<double>(grid.node_blocks[slot]) : 0.0;
        for (int n = 0; n < Block<2>::nodes; ++n) CHECK(grid.block_nodes(slot)[n][0] == value);
    }
}

TEST_CASE("a body without particles sorts to empty blocks") {
    Grid<3, float> grid;
    grid.layout = Layout<3>{0.1, {5, 5, 5}};
    std::vector<Particles<3, float>> bodies(2);
    const std::vector<Vector<3, double>> points{{0.2, 0.2, 0.2}};
    place<3, float>({points, {}}, grid, bodies);
    for (int round = 0; round < 2; ++round) {
        CHECK(bodies[0].begin == std::vector<std::uint32_t>{0, 1});
        CHECK(bodies[1].begin == std::vector<std::uint32_t>{0, 0});
        CHECK(grid.node_blocks.size() == 27);
        sort_into_blocks<3, float>(grid, bodies);
    }
}
