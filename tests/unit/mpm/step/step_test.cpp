#include "mpm/step/step.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <limits>
#include <utility>

#include "core/error.h"
#include "core/random.h"
#include "mpm/particles/motion.h"
#include "mpm/readings/pressure.h"
#include "mpm/state/ledger.h"
#include "support/box.h"
#include "support/mixed_tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// One particle of ice amid cells of 1 m, almost halfway between two nodes along x, along which it moves and
// is strained at these rates (m/s, 1/s). The node 1.49 cells off has 5e-5 of its mass.
template <int D>
Start<D> lone_particle(double speed, double rate) {
    auto start = test::long_ice_box<D>(20, 20);
    const Vector<D, double> along = Vector<D, double>::Unit(0);
    auto& body = start.bodies.emplace_back();
    body.material = Material::ice;
    body.points = {Vector<D, double>::Constant(10.0) + 0.49 * along};
    body.volume = 1.0;
    body.mass = start.parameters.ice.density;
    test::set_motion<D>(body.points[0], speed * along, rate * along * along.transpose(), body);
    return start;
}

}  // namespace

TEST_CASE_TEMPLATE("mass is exact and the momentum ledger closes to rounding", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const auto start = test::dropped_block_start<D>();
    const ThreadLimit limit(2);
    auto s = make_simulation<D, double>(start);
    const double mass = take_ledger(s).mass;
    for (int n = 0; n < 400; ++n) advance(s, stable_time_step(s));
    const auto ledger = take_ledger(s);
    CHECK(ledger.mass == doctest::Approx(mass).epsilon(1e-13));
    Vector<D, double> residual = ledger.momentum - s.accounts.wall_impulse;
    residual[D - 1] -= s.accounts.gravity_impulse;
    CHECK(residual.norm() < 1e-11 * std::abs(s.accounts.gravity_impulse));
}

TEST_CASE("the energy of a falling block and its water never exceeds its start") {
    auto s = make_simulation<2, double>(test::dropped_block_start<2>());
    const auto first = take_ledger(s);
    const double start = first.gravitational + first.elastic;
    double highest = 0.0, lowest = start;
    for (int n = 0; n < 600; ++n) {
        const double dt = stable_time_step(s);
        if (n % 20 > 0) {
            advance(s, dt);
            continue;
        }
        const double energy = test::advance_and_weigh(s, dt);
        highest = std::max(highest, energy);
        lowest = std::min(lowest, energy);
    }
    CHECK(highest <= start * (1 + 1e-9));
    CHECK(lowest < start);
    CHECK(take_ledger(s).kinetic > 0.0);
}

TEST_CASE("a particle at rest in empty space falls as a stone does") {
    Start<2> start;
    start.cell_size = 1.0;
    start.cells = {40, 400};
    start.bodies.emplace_back();
    start.bodies[0].points = {Vector<2, double>(20.3, 390.0)};
    start.bodies[0].mass = 1000.0;
    start.bodies[0].volume = 1.0;
    auto s = make_simulation<2, double>(start);
    const double dt = 1e-3;
    for (int n = 0; n <= 5000; ++n) advance(s, dt);  // the first of them only gives it half a step's velocity
    const Index<2> block = block_at<2>(s.grid.particle_blocks[0]);
    const auto x = global_position(s.grid.layout, block, s.bodies[0], 0);
    CHECK(x[0] == doctest::Approx(20.3).epsilon(1e-12));
    CHECK(x[1] == doctest::Approx(390.0 - 0.5 * 9.81 * 25.0).epsilon(1e-9));
}

TEST_CASE("grid pressure of still water is hydrostatic away from walls and surface") {
    auto s = make_simulation<2, double>(test::tank_start<2>(0.05, {40, 30}, 1.0, 60.0));
    const auto pressure = grid_pressure(s)[0];
    for_each_particle(s.grid, s.bodies[0], [&](std::size_t, const Index<2>& block, std::size_t p) {
        const double z = global_position(s.grid.layout, block, s.bodies[0], p)[1];
        if (z < 0.1 || z > 0.9) return;
        const double error = std::abs(static_cast<double>(pressure[p]) - 9810.0 * (1.0 - z));
        if (error > 0.003 * 9810.0) FAIL_CHECK("pressure off by " << error << " Pa at z = " << z);
    });
}

TEST_CASE("a simulation without particles has nothing to do and gravity bounds its step") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.1, {10, 10}, 0.0, 10.0));
    CHECK(s.particle_count() == 0);
    CHECK(stable_time_step(s) == doctest::Approx(std::sqrt(0.4 * 0.1 / 9.81)));
    advance(s, 0.1);
    CHECK(s.time == 0.0);
    CHECK(s.dt == 0.1);
    advance(s, 0.2);
    CHECK(s.time == 0.1);
}

TEST_CASE("a point outside of the tank is refused with its place") {
    Start<2> start = test::tank_start<2>(0.1, {10, 10}, 0.5, 10.0);
    start.bodies[0].points[0] = {5.0, 0.5};
    CHECK_THROWS_WITH_AS((make_simulation<2, float>(start)),
                         doctest::Contains("starts outside of the tank, at (5, 0.5) m"), NumericsError);
}

TEST_CASE("a strain that is not a number stops the run and names the place") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.1, {10, 10}, 0.5, 10.0));
    s.bodies[0].j[0] = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_WITH_AS(advance(s, 1e-3), doctest::Contains("not a number"), NumericsError);
}

TEST_CASE("water without volume stops the run and names the particle") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.1, {10, 10}, 0.5, 10.0));
    s.bodies[0].j[3] = -1.0f;
    const std::string name = "water particle " + std::to_string(s.bodies[0].id[3]);
    CHECK_THROWS_WITH_AS(advance(s, 1e-3), doctest::Contains(name.c_str()), NumericsError);
}

TEST_CASE("a step that moves something by more than half a cell is refused") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.1, {10, 10}, 0.5, 10.0));
    advance(s, 1.0);  // falls to 9.81 m/s
    CHECK_THROWS_WITH_AS(advance(s, 1e-3), doctest::Contains("cells in one step"), NumericsError);
}

TEST_CASE_TEMPLATE("a node with a sliver of a particle's mass may outrun the step, the particle may not",
                   Engine, TIDEWATER_ENGINES) {
    const auto run = [](double cells, double strain) {
        auto s = make_simulation<Engine::D, typename Engine::Real>(lone_particle<Engine::D>(cells, strain));
        const double start = test::read_state(s).x[0][0], speed = s.speeds.particle;
        for (int n = 0; n < 2; ++n) advance(s, 1.0);  // the first of them moves nothing
        CHECK(test::read_state(s).x[0][0] - start == doctest::Approx(cells).epsilon(1e-5));
        return speed;
    };
    CHECK(run(0.3, -0.6) > 1.1);
    CHECK(run(0.0, 0.96) > 1.4);
    for (const auto& [cells, strain] : {std::pair(0.5, 0.0), std::pair(0.0, -1.02), std::pair(0.3, 0.9)})
        CHECK_THROWS_WITH_AS(run(cells, strain), doctest::Contains("cells in one step"), NumericsError);
}

TEST_CASE_TEMPLATE("no particle's motion, its affine part counted, exceeds that of the fastest node", Engine,
                   TIDEWATER_ENGINES) {
    constexpr int D = Engine::D;
    auto start = test::mixed_tank<D>();
    for (auto& body : start.bodies) {
        body.velocity.clear();
        for (std::size_t n = 0; n < body.points.size(); ++n) {
            body.velocity.emplace_back();
            for (int axis = 0; axis < D; ++axis)
                body.velocity[n][axis] = random_uniform(9, static_cast<std::uint64_t>(axis), n) - 0.5;
        }
    }
    const auto s = make_simulation<D, typename Engine::Real>(start);
    for (const auto& particles : s.bodies) {
        double motion = 0.0;
        for (std::size_t slot = 0; slot < s.grid.particle_blocks.size(); ++slot)
            motion = std::max(motion, motion_of_block(s.grid, std::vector{particles}, slot).all);
        CHECK(motion > 0.1);
        CHECK(motion <= s.speeds.particle);
    }
}

TEST_CASE("still water stays at its level for a second and comes to rest") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.05, {20, 30}, 1.0, 62.0));
    while (s.time < 1.0) advance(s, stable_time_step(s));
    const auto ledger = take_ledger(s);
    const double mean_height = ledger.gravitational / (ledger.mass * s.parameters.gravity);
    CHECK(std::abs(mean_height - 0.5) < 0.05 * 0.05);
    CHECK(s.speeds.particle < 0.03);                              // 1 % of √(g D)
    CHECK(std::sqrt(2.0 * ledger.kinetic / ledger.mass) < 0.01);  // root mean square
}
