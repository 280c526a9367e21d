// Free flight: momenta are kept, whatever is thin, fast or far apart.
#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <limits>

#include "support/flight.h"
#include "support/state.h"

using namespace tidewater;
using namespace tidewater::mpm;
using test::Scene;

namespace {

// Blocks from the block of `from` to that of `to`, along x.
template <int D>
int blocks_between(BlockKey from, BlockKey to) {
    return block_at<D>(to)[0] - block_at<D>(from)[0];
}

// The greatest distance along an axis between two particles, cells.
template <int D>
double extent(const test::State<D>& state, double cell_size) {
    Vector<D, double> low = state.x[0], high = low;
    for (const auto& x : state.x) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return (high - low).maxCoeff() / cell_size;
}

struct Flight {
    int blocks = 0;       // along x, that of the particle that crossed fewest
    double extent = 0.0;  // of all particles at the end, cells
};

// Runs a start without weight and compares momenta at its end with those at its beginning, the angular ones
// with the sum of |x| m |v|. The run ends after so many steps or with that one that reaches the time `until`,
// s.
template <int D, class Real>
Flight check_momenta(const Start<D>& start, int steps, double tolerance, double until = 1e9) {
    auto s = make_simulation<D, Real>(start);
    const auto before = test::momenta_of(s);
    const auto initial = test::read_state(s);
    double scale = 0.0, arm_scale = 0.0;
    for (std::size_t p = 0; p < initial.x.size(); ++p) {
        scale += initial.mass[p] * initial.v[p].norm();
        arm_scale += initial.mass[p] * initial.v[p].norm() * initial.x[p].norm();
    }
    int changes_of_blocks = 0;
    for (int n = 0; n < steps && s.time < until; ++n) {
        const auto begin = s.bodies[0].begin;
        advance(s, std::min(0.9 * stable_time_step(s), 1.5e-3));
        changes_of_blocks += s.bodies[0].begin != begin;
    }
    const auto state = test::read_state(s);
    const auto after = test::momenta_of(s);
    CHECK(test::is_finite(state));
    CHECK(changes_of_blocks > 0);
    CHECK(s.accounts.wall_impulse.isZero(0.0));
    CHECK(after.mass == before.mass);
    const double linear = (after.linear - before.linear).norm() / scale;
    const double angular = (after.angular - before.angular).norm() / arm_scale;
    INFO("momentum off by " << linear << ", angular momentum by " << angular);
    CHECK(linear < tolerance);
    CHECK(angular < tolerance);
    Flight flight{std::numeric_limits<int>::max(), extent(state, s.grid.layout.cell_size)};
    for (std::size_t p = 0; p < state.x.size(); ++p)
        flight.blocks = std::min(flight.blocks, blocks_between<D>(initial.block[p], state.block[p]));
    return flight;
}

// Isolated particles that fly apart from the middle of the box at up to `speed`.
template <int D>
Start<D> spray(double speed, int count) {
    auto start = test::empty_start<D>(D == 2 ? 320 : 80);
    const Vector<D, double> middle = Vector<D, double>::Constant(0.5 * start.cells[0] * start.cell_size);
    for (const Material material : {Material::water, Material::ice}) {
        auto& body = start.bodies.emplace_back();
        body.material = material;
        body.surface = -1.0;
        for (int n = 0; n < count; ++n) {
            Vector<D, double> direction;
            for (int axis = 0; axis < D; ++axis)
                direction[axis] = 2.0 * random_uniform(start.bodies.size(), static_cast<std::uint64_t>(axis),
                                                       static_cast<std::uint64_t>(n)) -
                                  1.0;
            body.points.push_back(middle + 0.3 * middle[0] * direction);
            body.velocity.push_back(speed * direction);
        }
        body.volume = 0.25 * count * std::pow(start.cell_size, D);
        body.mass = 1000.0 * body.volume;
    }
    return start;
}

}  // namespace

TEST_CASE_TEMPLATE("free flight keeps linear and angular momentum to 1e-12 for every kind", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const Scene scene : {Scene::water, Scene::elastic_ice, Scene::fracturing_ice, Scene::mixed}) {
        CAPTURE(static_cast<int>(scene));
        check_momenta<D, double>(test::flying_start<D>(scene, D == 2 ? 44 : 20, D == 2 ? 10.0 : 5.0),
                                 D == 2 ? 400 : 150, 1e-12);
    }
}

TEST_CASE_TEMPLATE("particles that cross many blocks at high speed stay together and keep their momentum",
                   Dimension, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const Material material : {Material::water, Material::ice}) {
        auto start = test::empty_start<D>(D == 2 ? 400 : 100);
        start.parameters.ice.fracture = false;
        test::add_cube<D>({material, test::cells_at<D>(10.0, 40.0, 60.0), 3.0,
                           test::cells_at<D>(200.0, 0.0, 60.0), 3.0, 0.0},
                          start);
        // 15 blocks of 16 cells in 2D, 12 of 4 in 3D; a particle may end up to a block and its margin short.
        const int blocks = D == 2 ? 15 : 12;
        const double until = blocks * Block<D>::width * start.cell_size / 200.0;
        for (const Flight flight : {check_momenta<D, double>(start, 3000, 1e-12, until),
                                    check_momenta<D, float>(start, 3000, 1e-4, until)}) {
            CAPTURE(static_cast<int>(material));
            CHECK(flight.blocks >= blocks - 1);
            CHECK(flight.extent < 6.0);
        }
    }
}

TEST_CASE_TEMPLATE("a spray of isolated particles flies apart through empty space with its momentum",
                   Dimension, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    check_momenta<D, double>(spray<D>(8.0, 60), 300, 1e-12);
    check_momenta<D, float>(spray<D>(8.0, 60), 300, 1e-5);
}

TEST_CASE_TEMPLATE("one particle to a cell keeps its momentum and stays finite", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const Material material : {Material::water, Material::ice}) {
        auto start = test::empty_start<D>(60);
        test::add_cube<D>(
            {material, test::cells_at<D>(8.0, 6.0, 8.0), 6.0, test::cells_at<D>(1.0, 0.1, 0.3), 1.5, 2.0, 1},
            start);
        check_momenta<D, double>(start, 400, 1e-12);
    }
}

TEST_CASE("blocks that everything has left are given up") {
    auto start = test::empty_start<2>(400);
    test::add_cube<2>({Material::water, {20.0, 20.0}, 2.0, {20.0, 0.0}}, start);
    test::add_cube<2>({Material::water, {30.0, 350.0}, 2.0, {20.0, 0.0}}, start);
    auto s = make_simulation<2, float>(start);
    for (int n = 0; n < 500; ++n) advance(s, stable_time_step(s));
    CHECK(s.grid.particle_blocks.size() <= 8);
    CHECK(s.grid.node_blocks.size() <= 32);
    for (const BlockKey key : s.grid.particle_blocks) CHECK(block_at<2>(key)[0] > 4);
}
