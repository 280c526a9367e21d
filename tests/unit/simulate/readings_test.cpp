#include "readings.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "mpm/step/step.h"
#include "support/box.h"
#include "support/mixed_tank.h"

using namespace tidewater;

namespace {

// A gauge-less reading.
template <int D, class Real>
Reading<D> read(const mpm::Simulation<D, Real>& s) {
    return read_state(s, Instruments<D>{});
}

// Steps of unequal lengths, s, all of them stable for ice.
double uneven(int n) { return 2e-4 * (1.0 + 0.5 * std::sin(1.7 * n)); }

// A lone particle above nothing, which bears no stress.
template <int D>
mpm::Start<D> falling_ice() {
    auto start = test::long_ice_box<D>(12, 12, 9.81);
    auto& body = start.bodies.emplace_back();
    body.material = Material::ice;
    body.points = {Vector<D, double>::Constant(8.3)};
    body.volume = 0.25;
    body.mass = body.volume * start.parameters.ice.density;
    return start;
}

}  // namespace

TEST_CASE_TEMPLATE("a row of a falling body is that of its own time, whatever the steps", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto s = mpm::make_simulation<D, double>(falling_ice<D>());
    auto before = read(s);
    const double mass = before.ledger.mass, weight = 9.81 * mass;
    const double height = before.ledger.gravitational / weight;
    double worst = 0.0;
    for (int n = 0; n < 400; ++n) {
        mpm::advance(s, uneven(n));
        const auto after = read(s);
        for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0}) {
            if (after.time == before.time) continue;  // the first step has no length
            const double t = before.time + share * (after.time - before.time);
            const auto row = reading_between(before, after, t);
            CHECK(row.time == t);
            CHECK(row.accounts.gravity_impulse == doctest::Approx(-weight * t).epsilon(1e-12));
            CHECK(row.ledger.momentum[D - 1] == doctest::Approx(-weight * t).epsilon(1e-9));
            // Linear in time where the truth is a parabola: off by at most g Δt²/8 in the height, and by
            // ⅜ of (g Δt)² in v² where the motion's times lie to one side.
            const double step = 3e-4, fallen = 0.5 * 9.81 * t * t;
            CHECK(std::abs(height - fallen - row.ledger.gravitational / weight) < 9.81 * step * step);
            CHECK(std::abs(row.ledger.kinetic - weight * fallen) < weight * 9.81 * step * step);
            worst = std::max(worst, row.ledger.kinetic + row.ledger.gravitational - weight * height);
        }
        before = after;
    }
    CHECK(worst < 1e-6 * weight * height);
}

TEST_CASE("a falling block's rows are those of their own times from the first one on") {
    auto start = test::long_ice_box<2>(12, 12, 9.81);
    start.rigid.push_back({.size = {2.0, 2.0}, .center = {6.0, 8.0}});
    auto s = mpm::make_simulation<2, double>(start);
    auto before = read(s);
    CHECK(before.bodies[0].velocity[2] == 0.0);
    for (int n = 0; n < 50; ++n) {
        mpm::advance(s, uneven(n));
        const auto after = read(s);
        if (after.time > before.time) {
            const double t = before.time + 0.4 * (after.time - before.time);
            const auto row = reading_between(before, after, t);
            CHECK(row.bodies[0].velocity[2] == doctest::Approx(-9.81 * t).epsilon(1e-12));
            CHECK(std::abs(row.bodies[0].center[2] - 8.0 + 0.5 * 9.81 * t * t) < 9.81 * 3e-4 * 3e-4);
        }
        before = after;
    }
}

TEST_CASE("what balances in states balances in rows, and at a state's time its places are its own") {
    auto s = mpm::make_simulation<2, double>(test::dropped_block_start<2>());
    auto before = read(s);
    for (int n = 0; n < 300; ++n) {
        mpm::advance(s, mpm::stable_time_step(s));
        const auto after = read(s);
        if (after.time > before.time) {
            const auto row = reading_between(before, after, before.time + 0.37 * (after.time - before.time));
            Vector<2, double> open = row.ledger.momentum - row.accounts.wall_impulse;
            open[1] -= row.accounts.gravity_impulse;
            CHECK(open.norm() < 1e-11 * std::abs(row.accounts.gravity_impulse));
            const auto end = reading_between(before, after, after.time);
            CHECK(end.ledger.gravitational == after.ledger.gravitational);
            CHECK(end.ledger.elastic == after.ledger.elastic);
            CHECK(end.step == after.step);
            CHECK(row.step == before.step);
        }
        before = after;
    }
}

TEST_CASE("a gauge that is dry at one of two states tells what the nearer one does") {
    const double dry = std::numeric_limits<double>::quiet_NaN();
    Reading<2> before, after;
    after.time = 1.0;
    after.motion_time = 1.5;
    before.motion_time = 0.5;
    before.surface = {1.0, dry, dry};
    after.surface = {3.0, 2.0, dry};
    CHECK(reading_between(before, after, 0.25).surface[0] == 1.5);
    CHECK(std::isnan(reading_between(before, after, 0.25).surface[1]));
    CHECK(reading_between(before, after, 0.75).surface[1] == 2.0);
    CHECK(std::isnan(reading_between(before, after, 0.75).surface[2]));
}

TEST_CASE("a block's angle between two states lies between theirs, also across half a turn") {
    const auto turned = [](double degrees) {
        return Eigen::Quaterniond(
            Eigen::AngleAxisd(degrees * std::acos(-1.0) / 180.0, Eigen::Vector3d::UnitY()));
    };
    Reading<2> before, after;
    after.time = 1.0;
    before.motion_time = 0.5;
    after.motion_time = 1.5;
    before.bodies.resize(1);
    after.bodies.resize(1);
    before.bodies[0].rotation = turned(178.0);
    after.bodies[0].rotation = turned(-178.0);
    before.bodies[0].velocity = {1.0, 0.0, 0.0};
    after.bodies[0].velocity = {2.0, 0.0, 0.0};
    const auto row = reading_between(before, after, 0.75);
    CHECK(row.bodies[0].rotation.angularDistance(turned(181.0)) < 1e-12);
    CHECK(row.bodies[0].velocity[0] == 1.25);
}
