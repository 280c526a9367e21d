// The ends of a flume: piston and sponge.
#include <doctest/doctest.h>

#include <cmath>

#include "mpm/state/ledger.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

TEST_CASE("a piston starts at rest and its place is the integral of its speed") {
    const Piston solitary{.motion = PistonMotion::solitary, .height = 0.2, .depth = 1.0};
    const Piston sine{.motion = PistonMotion::sine, .amplitude = 0.1, .period = 2.0, .ramp = 3.0};
    for (const Piston& piston : {solitary, sine}) {
        double x = 0.0;
        const double dt = 1e-3;
        for (int n = 0; n < 9000; ++n) {
            x += dt * piston.velocity((n + 0.5) * dt);
            CHECK(std::abs(piston.position((n + 1) * dt) - x) < 1e-4);
        }
        CHECK(piston.position(0.0) == 0.0);
        CHECK(piston.velocity(-1.0) == 0.0);
    }
    // Stroke 2 H/κD tanh 3.8, then at rest.
    CHECK(solitary.position(9.0) == doctest::Approx(0.4 / std::sqrt(0.15) * std::tanh(3.8)));
    CHECK(solitary.velocity(9.0) == 0.0);
    CHECK(!Piston{}.exists());
}

TEST_CASE("the wall that a piston or a push replaces does not mirror, the others do") {
    Boundaries<2> boundaries;
    CHECK(mirrors_of(boundaries)[0][0] == Mirror::slip);
    boundaries.piston.height = 0.2;
    CHECK(mirrors_of(boundaries)[0][0] == Mirror::none);
    CHECK(mirrors_of(boundaries)[0][1] == Mirror::slip);
    CHECK(mirrors_of(boundaries)[1][0] == Mirror::slip);
    boundaries.piston.height = 0.0;
    boundaries.push.speed = 1.0;
    CHECK(mirrors_of(boundaries)[0][0] == Mirror::none);
}

TEST_CASE("a sponge's damping rises with the square of the way into it") {
    const Sponge sponge{.from = 6.0, .width = 4.0, .rate = 8.0};
    CHECK(sponge.damping(6.0) == 0.0);
    CHECK(sponge.damping(8.0) == doctest::Approx(2.0));
    CHECK(sponge.damping(10.0) == doctest::Approx(8.0));
    CHECK(Sponge{}.damping(10.0) == 0.0);
}

TEST_CASE("water between a piston and a sponge keeps closed ledgers of momentum and energy") {
    auto start = test::tank_start<2>(0.1, {30, 16}, 1.0, 30.0);
    start.parameters.boundaries.piston = {.motion = PistonMotion::solitary, .height = 0.2, .depth = 1.0};
    start.parameters.boundaries.sponge = {.from = 1.5, .width = 1.5, .rate = 20.0};
    auto s = make_simulation<2, double>(start);
    const auto energy = [&] {
        const auto ledger = take_ledger(s);
        return ledger.kinetic + ledger.gravitational + ledger.elastic - s.accounts.boundary_work;
    };
    const double before = energy();
    while (s.time < 3.0) advance(s, stable_time_step(s));
    Vector<2, double> open = take_ledger(s).momentum - s.accounts.wall_impulse;
    open[1] -= s.accounts.gravity_impulse;
    CHECK(open.norm() < 1e-10 * std::abs(s.accounts.gravity_impulse));
    CHECK(s.accounts.boundary_work > 100.0);
    CHECK(energy() < before + 1.0);
}
