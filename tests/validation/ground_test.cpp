// Ice and water on ground, by the engine, against closed forms (mpm/boundaries/ground.h, drag.h).
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mpm/state/ledger.h"
#include "mpm/step/settle.h"
#include "support/box.h"
#include "support/rough_ground.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double gravity = 9.81, infinity = std::numeric_limits<double>::infinity();

GroundRule rubbing(double friction) {
    GroundRule rule;
    rule.ice.friction = friction;
    return rule;
}

// A slab of elastic ice, 4 m long and 1 m high (8 cells), on a slope.
template <int D, class Real>
Simulation<D, Real> slab_on_slope(double angle, const GroundRule& rule, Transfer transfer) {
    const double cell = 0.125, rise = std::tan(angle), length = 12.0;
    Start<D> start;
    start.cell_size = cell;
    start.cells.fill(12);  // across, in 3D
    start.cells[0] = static_cast<int>(length / cell);
    const auto height = [&](double x) { return 0.53 + rise * x; };
    start.cells[D - 1] = static_cast<int>(std::ceil((height(length) + 2.0) / cell));
    start.parameters.transfer = transfer;
    start.parameters.ice.youngs_modulus = 1e7;
    start.parameters.ice.fracture = false;
    test::lay_bed<D>(height, rule, start);
    test::add_ice<D>(
        [&](const Vector<D, double>& x) {
            const double up = (x[D - 1] - height(8.0)) * std::cos(angle) - (x[0] - 8.0) * std::sin(angle);
            const double along = (x[0] - 8.0) * std::cos(angle) + (x[D - 1] - height(8.0)) * std::sin(angle);
            const bool across = D == 2 || std::abs(x[1] - 0.75) < 0.25;
            return up > 0.0 && up < 1.0 && std::abs(along) < 2.0 && across;
        },
        start);
    return make_simulation<D, Real>(start);
}

// Down the slope, m/s.
template <int D, class Real>
double speed_down(const Simulation<D, Real>& s, double angle) {
    const auto ledger = take_ledger(s);
    return -(ledger.momentum[0] * std::cos(angle) + ledger.momentum[D - 1] * std::sin(angle)) / ledger.mass;
}

// The acceleration of the slab down the slope over half a second, after 0.2 s, m/s².
template <int D, class Real>
double acceleration(double angle, double friction, Transfer transfer = Transfer::apic) {
    auto s = slab_on_slope<D, Real>(angle, rubbing(friction), transfer);
    while (s.time < 0.2) advance(s, stable_time_step(s));
    const double before = speed_down(s, angle), from = s.time + s.dt;
    while (s.time < 0.7) advance(s, stable_time_step(s));
    return (speed_down(s, angle) - before) / (s.time + s.dt - from);
}

// How far the slab, once at rest, moves down the slope in a second, m.
template <int D, class Real>
double creep(double angle, double friction, Transfer transfer = Transfer::apic) {
    auto s = slab_on_slope<D, Real>(angle, rubbing(friction), transfer);
    begin_settling(s);
    while (!settle_step(s, 100.0)) REQUIRE(s.settling.time < 10.0);
    double moved = 0.0;
    while (s.time < 1.0) {
        advance(s, stable_time_step(s));
        moved += s.dt * speed_down(s, angle);
    }
    return moved;
}

constexpr double steep = std::numbers::pi / 6.0;  // tan 0.577

double sliding_acceleration(double friction) {
    return gravity * (std::sin(steep) - friction * std::cos(steep));
}

}  // namespace

TEST_CASE_TEMPLATE(
    "ice slides down a plane above its friction's angle, by g (sin - mu cos), and stands below", E,
    TIDEWATER_ENGINES) {
    constexpr int D = E::D;
    using Real = typename E::Real;
    for (const double friction : D == 2 ? std::vector{0.2, 0.4} : std::vector{0.4}) {
        CAPTURE(friction);
        CHECK(std::abs(acceleration<D, Real>(steep, friction) / sliding_acceleration(friction) - 1.0) < 0.02);
    }
    for (const double friction : D == 2 ? std::vector{0.6, infinity} : std::vector{0.6}) {
        CAPTURE(friction);
        CHECK(std::abs(creep<D, Real>(steep, friction)) < 1e-4);  // a free one goes 2.5 m
    }
}

TEST_CASE("with restored velocities friction is the same") {
    CHECK(std::abs(acceleration<2, double>(steep, 0.3, Transfer::restored) / sliding_acceleration(0.3) -
                   1.0) < 0.02);
    for (const double friction : {0.6, infinity})
        CHECK(std::abs(creep<2, double>(steep, friction, Transfer::restored)) < 1e-4);
}

// The momentum that the ground takes and the work of friction are what the ice loses.
TEST_CASE("friction's impulse and work are in the ledger") {
    auto s = slab_on_slope<2, double>(steep, rubbing(0.3), Transfer::apic);
    const auto energy = [&] {
        const auto ledger = take_ledger(s);
        return ledger.kinetic + ledger.gravitational + ledger.elastic - s.accounts.friction_work;
    };
    const double start = energy();
    while (s.time < 0.7) advance(s, stable_time_step(s));
    test::check_momentum<2, double>(s, Vector<2, double>::Zero(), std::abs(s.accounts.gravity_impulse));
    const double lost = start - energy();
    CHECK(s.accounts.friction_work < 0.0);
    CHECK(std::abs(lost) < 0.03 * -s.accounts.friction_work);
    // Its force μ m g cos over the way that it slid, but for the first bounces.
    const double mass = take_ledger(s).mass, way = 0.5 * sliding_acceleration(0.3) * 0.7 * 0.7;
    CHECK(-s.accounts.friction_work ==
          doctest::Approx(0.3 * mass * gravity * std::cos(steep) * way).epsilon(0.1));
}

// Weertman's law on a slope: ρ g d sin = C u^(1/3) at the end.
TEST_CASE("ice by Weertman's law slides as fast as its weight drives it") {
    GroundRule rule;
    rule.ice.weertman = 5561.0;
    auto s = slab_on_slope<2, double>(steep, rule, Transfer::apic);
    const double expected = std::pow(900.0 * gravity * 1.0 * std::sin(steep) / rule.ice.weertman, 3.0);
    while (s.time < 2.0) advance(s, stable_time_step(s));
    double moved = 0.0, from = s.time;
    while (s.time < 3.0) {
        advance(s, stable_time_step(s));
        moved += s.dt * speed_down(s, steep);
    }
    CHECK(std::abs(moved / (s.time - from) / expected - 1.0) < 0.05);
}

// A bar on rough ground, pushed at its end, slips as far as l = √(2 E' u0/(μ ρ g)) from there and stays where
// it was beyond; in between its displacement is u = μ ρ g (l − x)²/(2 E'). The push is slow: a bar that rings
// rubs less, since its friction then points to and fro (7 % of the slope below at seven times the speed).
TEST_CASE("elastic ice that is pushed slips from the push on, as far as friction lets it") {
    const double cell = 0.25, friction = 0.5;
    Start<2> start;
    start.cell_size = cell;
    start.cells = {80, 16};
    start.parameters.ice.youngs_modulus = 1e7;
    start.parameters.ice.fracture = false;
    start.parameters.boundaries.push = {0.003, 3.0};
    test::lay_bed<2>([](double) { return 0.6; }, rubbing(friction), start);
    test::add_ice<2>(test::box_shape<2>({0.25, 0.6}, {18.0, 1.6}), start);
    auto s = make_simulation<2, double>(start);
    begin_settling(s);
    while (!settle_step(s, 30.0)) REQUIRE(s.settling.time < 10.0);
    const auto rest = test::read_state(s);
    while (s.time < 9.0) advance(s, stable_time_step(s));
    const auto now = test::read_state(s);
    const IceModel& ice = start.parameters.ice;
    const double stiffness = ice.youngs_modulus / (1.0 - ice.poisson_ratio * ice.poisson_ratio);
    const double curvature = std::sqrt(friction * ice.density * gravity / (2.0 * stiffness));
    // √u falls linearly along the bar: means over slices of 1 m at x and x + 4 m.
    const auto displacement = [&](double x) {
        double sum = 0.0, count = 0.0;
        for (std::size_t p = 0; p < rest.x.size(); ++p) {
            if (std::abs(rest.x[p][0] - x) > 0.5) continue;
            sum += now.x[p][0] - rest.x[p][0];
            count += 1.0;
        }
        return sum / count;
    };
    const double slope = (std::sqrt(displacement(2.0)) - std::sqrt(displacement(6.0))) / 4.0;
    CHECK(std::abs(slope / curvature - 1.0) < 0.05);
    const double slip = 2.0 + std::sqrt(displacement(2.0)) / curvature;
    CHECK(slip > 7.0);
    CHECK(slip < 14.0);
    CHECK(std::abs(displacement(17.0)) < 0.02 * displacement(2.0));
}

namespace {

// Water a metre deep that runs down a slope of 1 in 10.
struct Flow {
    double depth = 0.0, speed = 0.0;  // mean over a window that no end has reached yet
};
Flow run_down(const DragLaw& drag) {
    const double cell = 0.125, fall = 0.1, length = 90.0;
    Start<2> start;
    start.cell_size = cell;
    const auto height = [&](double x) { return 0.3 + fall * (length - x); };
    start.cells = {static_cast<int>(length / cell), static_cast<int>((height(0.0) + 2.0) / cell)};
    start.parameters.water.sound_speed = 35.0;
    start.parameters.boundaries.drag.bed = drag;
    test::lay_bed<2>(height, {}, start);
    auto& water = start.bodies.emplace_back();
    water.points = test::lattice<2>(cell, start.cells, 2, 0.0, [&](const auto& x) {
        return x[0] > 5.0 && x[0] < 80.0 && x[1] > height(x[0]) && x[1] < height(x[0]) + 1.0;
    });
    water.volume = 0.25 * cell * cell * static_cast<double>(water.points.size());
    water.mass = start.parameters.water.density * water.volume;
    for (const auto& x : water.points) {
        water.velocity.push_back(2.5 * Vector<2, double>(1.0, -fall));
        water.head.push_back(height(x[0]) + 1.0 - x[1]);
    }
    auto s = make_simulation<2, float>(start);
    Flow mean;
    int count = 0;
    while (s.time < 6.0) {
        advance(s, stable_time_step(s));
        if (s.time < 5.5 || s.step % 20 != 0) continue;
        double mass = 0.0, momentum = 0.0;
        const auto state = test::read_state(s);
        for (std::size_t p = 0; p < state.x.size(); ++p) {
            if (std::abs(state.x[p][0] - 56.0) > 8.0) continue;
            mass += state.mass[p];
            momentum += state.mass[p] * state.v[p][0];
        }
        mean.depth += mass / (16.0 * start.parameters.water.density);
        mean.speed += momentum / mass;
        ++count;
    }
    mean.depth /= count;
    mean.speed /= count;
    return mean;
}

}  // namespace

// Normal depth: g h S = C u² with S = sin cos of the slope's angle.
TEST_CASE("water on a rough slope runs at its normal depth") {
    const double slope = 0.1 / (1.0 + 0.1 * 0.1);
    DragLaw law;
    law.coefficient = 0.1;
    const Flow by_drag = run_down(law);
    const double discharge = by_drag.speed * by_drag.depth;
    const double normal = std::cbrt(law.coefficient * discharge * discharge / (gravity * slope));
    CHECK(std::abs(by_drag.depth / normal - 1.0) < 0.05);
    law = {};
    law.manning = 0.1;
    const Flow by_manning = run_down(law);
    const double unit_discharge = by_manning.speed * by_manning.depth;
    const double normal_by_manning = std::pow(law.manning * unit_discharge / std::sqrt(slope), 0.6);
    CHECK(std::abs(by_manning.depth / normal_by_manning - 1.0) < 0.05);
}
