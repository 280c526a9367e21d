#include "mpm/step/settle.h"

#include <doctest/doctest.h>

#include "core/error.h"
#include "mpm/state/ledger.h"
#include "support/flight.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// A slab 12 m high and 30 m long on the frictionless bottom, without stress.
Start<2> slab_start() {
    Start<2> start;
    start.cell_size = 1.0;
    start.cells = {40, 20};
    start.parameters.ice = {};
    start.parameters.ice.beta_p0 = 2e4;  // weaker than the ringing of a sudden start
    start.parameters.ice.beta = 0.2;
    auto& ice = start.bodies.emplace_back();
    ice.material = Material::ice;
    ice.points =
        test::lattice<2>(1.0, start.cells, 2, 0.0, [](const auto& x) { return x[0] < 30.0 && x[1] < 12.0; });
    ice.volume = 30.0 * 12.0;
    ice.mass = 900.0 * ice.volume;
    return start;
}

template <class Real>
long settle(Simulation<2, Real>& s, double tolerance) {
    long steps = 0;
    begin_settling(s);
    while (!settle_step(s, tolerance)) {
        if (++steps == 20000) FAIL("does not settle");
    }
    return steps;
}

template <class Real>
double mean_vertical_stress_at_base(const Simulation<2, Real>& s) {
    const auto& ice = s.bodies[0];
    const IceModel& model = s.parameters.ice;
    double sum = 0.0, count = 0.0;
    for (std::size_t slot = 0; slot + 1 < ice.begin.size(); ++slot) {
        const auto block = block_at<2>(s.grid.particle_blocks[slot]);
        for (std::size_t p = ice.begin[slot]; p < ice.begin[slot + 1]; ++p) {
            const auto at = global_position(s.grid.layout, block, ice, p);
            if (at[1] < 1.0 || at[1] > 2.0 || at[0] < 5.0 || at[0] > 25.0) continue;
            const double xx = static_cast<double>(ice.strain[0][p]),
                         zz = static_cast<double>(ice.strain[2][p]);
            sum += 0.5 * model.shear_modulus() * (zz - xx) + 0.5 * model.bulk_modulus(2) * (xx + zz);
            count += 1.0;
        }
    }
    return sum / count;
}

}  // namespace

TEST_CASE_TEMPLATE("a slab without stress settles under its weight, unbroken, and time begins at rest", Real,
                   float, double) {
    auto s = make_simulation<2, Real>(slab_start());
    const auto alpha = s.bodies[0].alpha;
    const long steps = settle(s, 1e3);
    MESSAGE("settled after " << steps << " steps, waves of " << s.settling.stress << " Pa");
    CHECK(s.settling.stress <= 1e3);
    CHECK(s.settling.going == 0);
    CHECK(s.bodies[0].alpha == alpha);
    CHECK(s.time == 0.0);
    CHECK(s.step == 0);
    CHECK(s.dt == 0.0);
    CHECK(take_ledger(s).momentum.isZero());
    CHECK(s.accounts.wall_impulse.isZero());
    // σzz = −ρ g h, h = 10.5 m above the layer.
    CHECK(mean_vertical_stress_at_base(s) == doctest::Approx(-900.0 * 9.81 * 10.5).epsilon(0.02));
}

TEST_CASE("a settled slab stays at rest, one that was not settled rings") {
    const auto fastest = [](bool settled) {
        auto start = slab_start();
        start.parameters.ice.fracture = false;
        auto s = make_simulation<2, double>(start);
        if (settled) settle(s, 300.0);
        double most = 0.0;
        while (s.time < 0.2) {
            advance(s, stable_time_step(s));
            most = std::max(most, s.speeds.particle);
        }
        return most;
    };
    const double ringing = fastest(false), settled = fastest(true);
    MESSAGE("fastest node: settled " << settled << " m/s, not settled " << ringing << " m/s");
    CHECK(settled < 0.05 * ringing);
}

TEST_CASE("settling goes on from a saved state to the same bits") {
    auto s = make_simulation<2, float>(slab_start());
    begin_settling(s);
    for (int n = 0; n < 40; ++n) settle_step(s, 1e3);
    CHECK(s.settling.time > 0.0);
    CHECK(s.time == 0.0);
    auto copy = s;
    while (!settle_step(s, 1e3)) {
    }
    while (!settle_step(copy, 1e3)) {
    }
    CHECK(state_hash(s) == state_hash(copy));
}
