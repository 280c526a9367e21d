#include "mpm/step/restore.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "mpm/state/ledger.h"
#include "support/flight.h"
#include "support/state.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// Amplitude of a shear wave v = sin(kx) across disordered water without gravity and pressure, after some
// steps in which nothing moves (Δt = 0), over that at the start.
double left_after(int steps, double cells, Transfer transfer) {
    auto start = test::tank_start<2>(1.0, {96, 16}, 16.0, 10.0, 0.0, {0, 0}, 2, 0.3);
    start.parameters.gravity = 0.0;
    start.parameters.transfer = transfer;
    const double k = 2.0 * std::numbers::pi / cells;
    auto& water = start.bodies[0];
    for (const auto& x : water.points) water.velocity.emplace_back(0.0, 1e-3 * std::sin(k * x[0]));
    for (const auto& x : water.points) {
        water.gradient.push_back(Matrix<2, double>::Zero());
        water.gradient.back()(1, 0) = 1e-3 * k * std::cos(k * x[0]);
    }
    auto s = make_simulation<2, double>(start);
    const auto amplitude = [&] {
        const auto state = test::read_state(s);
        double sum = 0.0, weight = 0.0;
        for (std::size_t p = 0; p < state.x.size(); ++p) {
            if (state.x[p][0] < 24.0 || state.x[p][0] > 72.0 || state.x[p][1] < 4.0 || state.x[p][1] > 12.0)
                continue;
            const double shape = std::sin(k * state.x[p][0]);
            sum += shape * state.v[p][1];
            weight += shape * shape;
        }
        return sum / weight;
    };
    const double first = amplitude();
    for (int n = 0; n < steps; ++n) advance(s, 1e-12);
    return amplitude() / first;
}

}  // namespace

TEST_CASE("APIC loses 0.024 (k dx)^4 of a wave per step, the restored transfer the square of that") {
    for (const double cells : {8.0, 12.0}) {
        const double kdx = 2.0 * std::numbers::pi / cells, share = 0.024 * std::pow(kdx, 4);
        const int steps = 10;
        const double apic = 1.0 - std::pow(left_after(steps, cells, Transfer::apic), 1.0 / steps);
        const double restored = 1.0 - std::pow(left_after(steps, cells, Transfer::restored), 1.0 / steps);
        MESSAGE(cells << " cells per wave: a step loses " << apic << ", restored " << restored << "; derived "
                      << share);
        CHECK(apic == doctest::Approx(share).epsilon(0.4));
        CHECK(restored < 0.25 * apic);
        CHECK(restored > -1e-4);
    }
}

TEST_CASE_TEMPLATE("in free flight the restored transfer keeps momentum and angular momentum to rounding",
                   Dimension, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto start = test::flying_start<D>(test::Scene::water, D == 2 ? 40 : 16, D == 2 ? 10.0 : 4.0);
    start.parameters.transfer = Transfer::restored;
    auto s = make_simulation<D, double>(start);
    const auto before = test::momenta_of(s);
    for (int n = 0; n < 100; ++n) advance(s, 1e-3);
    const auto after = test::momenta_of(s);
    CHECK((after.linear - before.linear).norm() < 1e-12 * before.linear.norm());
    CHECK((after.angular - before.angular).norm() < 1e-12 * before.linear.norm());
    CHECK(s.accounts.wall_impulse.norm() < 1e-12 * before.linear.norm());
}

TEST_CASE("between walls the restored transfer's momentum is accounted for, and the tank stays at rest") {
    auto start = test::tank_start<2>(0.05, {20, 20}, 0.7, 31.0, 0.0, {0, 0}, 2, 0.2);
    start.parameters.transfer = Transfer::restored;
    auto s = make_simulation<2, double>(start);
    for (int n = 0; n < 1000; ++n) advance(s, stable_time_step(s));
    const auto ledger = take_ledger(s);
    Vector<2, double> residual = ledger.momentum - s.accounts.wall_impulse;
    residual[1] -= s.accounts.gravity_impulse;
    CHECK(residual.norm() < 1e-11 * std::abs(s.accounts.gravity_impulse));
    CHECK(s.speeds.particle < 0.02);
}
