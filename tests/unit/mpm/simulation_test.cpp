#include "mpm/simulation.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <limits>

#include "core/error.h"
#include "mpm/ledger.h"
#include "mpm/pressure.h"
#include "support/dense_twin.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int D>
Start<D> small_start(WallRule rule = WallRule::slip) {
    Index<D> cells;
    cells.fill(D == 2 ? 20 : 9);
    cells[D - 1] = D == 2 ? 24 : 12;
    Vector<D, double> corner = Vector<D, double>::Constant(D == 2 ? 0.33 : 0.24);
    corner[D - 1] = D == 2 ? 0.55 : 0.35;  // partly in the water, off-centre, so that the block turns
    Start<D> start = test::tank_start<D>(0.05, cells, D == 2 ? 0.6 : 0.4, 20.0, 0.2, corner, 2, 0.5);
    for (auto& axis : start.parameters.walls) axis = {rule, rule};
    return start;
}

// Greatest difference of position (m) and velocity (m/s) between engine and twin.
template <int D, class Real>
std::pair<double, double> difference(const Simulation<D, Real>& s, const test::DenseTwin<D>& twin) {
    double position = 0, velocity = 0;
    for (const auto& particles : s.bodies) {
        for_each_particle(particles, [&](std::size_t slot, std::size_t p) {
            const auto& other = twin.particles[particles.id[p]];
            const Index<D> block = s.grid.layout.block_at(s.grid.particle_blocks[slot]);
            position = std::max(
                position,
                (global_position<D, Real>(s.grid.layout, block, particles.position[p]) - other.x).norm());
            velocity = std::max(velocity, (particles.velocity[p].template cast<double>() - other.v).norm());
        });
    }
    return {position, velocity};
}

template <int D, class Real>
Simulation<D, Real> run(const Start<D>& start, int steps, int threads) {
    const ThreadLimit limit(threads);
    auto s = make_simulation<D, Real>(start);
    for (int n = 0; n < steps; ++n) advance(s, stable_time_step(s));
    return s;
}

}  // namespace

TEST_CASE_TEMPLATE("agrees with the dense twin to rounding, for every wall rule", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const ThreadLimit serial(1);  // `difference` is not made for several threads
    for (const WallRule rule : {WallRule::slip, WallRule::stick, WallRule::separate}) {
        const auto start = small_start<D>(rule);
        auto s = make_simulation<D, double>(start);
        auto single = make_simulation<D, float>(start);
        test::DenseTwin<D> twin(start);
        const int steps = D == 2 ? 120 : 40;
        for (int n = 0; n < steps; ++n) {
            const double dt = stable_time_step(s);
            advance(s, dt);
            advance(single, dt);
            twin.step(dt);
        }
        const auto [position, velocity] = difference(s, twin);
        CHECK(position < 1e-12);
        CHECK(velocity < 1e-10);
        const auto [single_position, single_velocity] = difference(single, twin);
        CHECK(single_position < 1e-5);
        CHECK(single_velocity < 2e-3);
    }
}

TEST_CASE_TEMPLATE("gives the same bits with 1, 2, 5 and 16 threads", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const auto start = small_start<D>();
    const auto serial = run<D, float>(start, 300, 1);
    const auto serial_ledger = take_ledger(serial);
    for (const int threads : {2, 5, 16}) {
        const auto parallel = run<D, float>(start, 300, threads);
        CHECK(state_hash(parallel) == state_hash(serial));
        CHECK(take_ledger(parallel).kinetic == serial_ledger.kinetic);
        CHECK(parallel.wall_impulse == serial.wall_impulse);
    }
}

TEST_CASE_TEMPLATE("mass is exact and the momentum ledger closes to rounding", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const auto start = small_start<D>();
    const auto s = run<D, double>(start, 400, 2);
    const auto ledger = take_ledger(s);
    CHECK(ledger.mass == doctest::Approx(start.bodies[0].mass + start.bodies[1].mass).epsilon(1e-13));
    Vector<D, double> residual = ledger.momentum - s.wall_impulse;
    residual[D - 1] -= s.gravity_impulse;
    CHECK(residual.norm() < 1e-11 * std::abs(s.gravity_impulse));
}

TEST_CASE_TEMPLATE("free flight keeps linear and angular momentum to 1e-12", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto start = small_start<D>();
    start.parameters.gravity = 0.0;
    for (auto& body : start.bodies) body.surface = -1.0;  // no pressure at the start
    for (auto& body : start.bodies) {
        for (auto& x : body.points)
            x = x * 0.5 + Vector<D, double>::Constant(D == 2 ? 0.25 : 0.11);  // away from the walls
        body.volume *= std::pow(0.5, D);
    }
    auto s = make_simulation<D, double>(start);
    // A spinning, shearing start.
    const auto angular_momentum = [&] {
        double sum = 0;
        for (const auto& particles : s.bodies) {
            for (std::size_t slot = 0; slot + 1 < particles.begin.size(); ++slot) {
                const Index<D> block = s.grid.layout.block_at(s.grid.particle_blocks[slot]);
                for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                    const auto x = global_position<D, double>(s.grid.layout, block, particles.position[p]);
                    const auto& v = particles.velocity[p];
                    const auto& g = particles.gradient[p];
                    sum += particles.mass * (x[D - 1] * v[0] - x[0] * v[D - 1] +
                                             0.25 * s.grid.layout.cell_size * (g(0, D - 1) - g(D - 1, 0)));
                }
            }
        }
        return sum;
    };
    for (auto& particles : s.bodies) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            particles.velocity[p][0] = 0.03 + 0.01 * particles.position[p][D - 1];
            particles.velocity[p][D - 1] = -0.02 * particles.position[p][0];
        }
    }
    const auto momentum = take_ledger(s).momentum;
    const double angular = angular_momentum();
    for (int n = 0; n < 100; ++n) advance(s, 0.5 * stable_time_step(s));
    CHECK((take_ledger(s).momentum - momentum).norm() < 1e-12 * momentum.norm());
    CHECK(angular_momentum() == doctest::Approx(angular).epsilon(1e-12));
    CHECK(s.wall_impulse.isZero());
}

TEST_CASE("the energy of a falling block and its water never exceeds its start") {
    auto s = make_simulation<2, double>(small_start<2>());
    const auto energy = [&] {
        const auto ledger = take_ledger(s);
        return ledger.kinetic + ledger.gravitational + ledger.elastic;
    };
    const double start = energy();
    double highest = start;
    for (int n = 0; n < 600; ++n) {
        advance(s, stable_time_step(s));
        if (n % 20 == 0) highest = std::max(highest, energy());
    }
    CHECK(highest <= start * (1 + 1e-9));
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
    for (int n = 0; n < 5000; ++n) advance(s, dt);
    const Index<2> block = s.grid.layout.block_at(s.grid.particle_blocks[0]);
    const auto x = global_position<2, double>(s.grid.layout, block, s.bodies[0].position[0]);
    CHECK(x[0] == doctest::Approx(20.3).epsilon(1e-12));
    CHECK(x[1] == doctest::Approx(390.0 - 0.5 * 9.81 * 5.0 * (5.0 + dt)).epsilon(1e-9));
}

TEST_CASE("grid pressure of still water is hydrostatic away from walls and surface") {
    auto s = make_simulation<2, double>(test::tank_start<2>(0.05, {40, 30}, 1.0, 60.0));
    const auto pressure = grid_pressure(s)[0];
    for_each_particle(s.bodies[0], [&](std::size_t slot, std::size_t p) {
        const Index<2> block = s.grid.layout.block_at(s.grid.particle_blocks[slot]);
        const double z = global_position<2, double>(s.grid.layout, block, s.bodies[0].position[p])[1];
        if (z < 0.1 || z > 0.9) return;
        const double error = std::abs(static_cast<double>(pressure[p]) - 9810.0 * (1.0 - z));
        if (error > 0.003 * 9810.0) FAIL_CHECK("pressure off by " << error << " Pa at z = " << z);
    });
}

TEST_CASE("a simulation without particles has nothing to do and gravity bounds its step") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.1, {10, 10}, 0.0, 10.0));
    CHECK(s.particle_count() == 0);
    CHECK(stable_time_step(s) == doctest::Approx(std::sqrt(0.5 * 0.1 / 9.81)));
    advance(s, 0.1);
    CHECK(s.time == 0.1);
}

TEST_CASE("a point outside of the tank is refused with its place") {
    Start<2> start = test::tank_start<2>(0.1, {10, 10}, 0.5, 10.0);
    start.bodies[0].points[0] = {5.0, 0.5};
    CHECK_THROWS_WITH_AS((make_simulation<2, float>(start)), doctest::Contains("left the tank at (5, 0.5) m"),
                         NumericsError);
}

TEST_CASE("a velocity that is not a number stops the run and names the particle") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.1, {10, 10}, 0.5, 10.0));
    s.bodies[0].velocity[0][0] = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_WITH_AS(advance(s, 1e-3), doctest::Contains("not a number"), NumericsError);
}

TEST_CASE("still water stays at its level for a second and comes to rest") {
    auto s = make_simulation<2, float>(test::tank_start<2>(0.05, {20, 30}, 1.0, 62.0));
    while (s.time < 1.0) advance(s, stable_time_step(s));
    const auto ledger = take_ledger(s);
    const double mean_height = ledger.gravitational / (ledger.mass * s.parameters.gravity);
    CHECK(std::abs(mean_height - 0.5) < 0.05 * 0.05);
    CHECK(s.speeds.particle < 0.03);                               // 1 % of √(g D)
    CHECK(std::sqrt(2.0 * ledger.kinetic / ledger.mass) < 0.01);  // root mean square
}
