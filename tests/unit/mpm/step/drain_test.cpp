#include "mpm/step/drain.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "mpm/state/ledger.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int D>
Start<D> brimful_start() {
    Index<D> cells;
    cells.fill(10);
    cells[0] = 20;
    auto start = test::tank_start<D>(0.1, cells, 0.6, 30.0);
    start.parameters.boundaries.outlet = {.from = 1.0, .level = 0.5};
    return start;
}

}  // namespace

TEST_CASE_TEMPLATE("an outlet takes the water above its level beyond its edge and nothing else", Real, float,
                   double) {
    const auto check = [&]<int D>(std::integral_constant<int, D>) {
        auto s = make_simulation<D, Real>(brimful_start<D>());
        const auto before = take_ledger(s);
        const std::size_t all = s.particle_count();
        std::set<std::uint32_t> kept;
        for (std::size_t slot = 0; slot + 1 < s.bodies[0].begin.size(); ++slot) {
            const auto block = block_at<D>(s.grid.particle_blocks[slot]);
            for (std::size_t p = s.bodies[0].begin[slot]; p < s.bodies[0].begin[slot + 1]; ++p) {
                const auto at = global_position(s.grid.layout, block, s.bodies[0], p);
                if (at[0] < 1.0 || at[D - 1] < 0.5) kept.insert(s.bodies[0].id[p]);
            }
        }
        drain(s.parameters, s.grid, s.bodies, s.accounts.outflow);
        const auto& id = s.bodies[0].id;
        CHECK(std::set<std::uint32_t>(id.begin(), id.end()) == kept);
        CHECK(all - id.size() == (D == 2 ? 20u * 2 : 20u * 20 * 2));
        CHECK(s.bodies[0].begin.back() == id.size());
        CHECK(std::is_sorted(s.bodies[0].begin.begin(), s.bodies[0].begin.end()));
        for_each_column(s.bodies[0], [&](const std::string&, const auto& column) {
            CHECK((column.empty() || column.size() == id.size()));
        });
        const auto after = take_ledger(s);
        CHECK(after.mass + s.accounts.outflow.mass == doctest::Approx(before.mass));
        CHECK(after.gravitational + after.elastic + after.kinetic + s.accounts.outflow.energy() ==
              doctest::Approx(before.gravitational + before.elastic + before.kinetic));
        const auto hash = state_hash(s);
        drain(s.parameters, s.grid, s.bodies, s.accounts.outflow);
        CHECK(state_hash(s) == hash);
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

TEST_CASE("water that runs out through the outlet leaves a closed ledger of mass and momentum") {
    auto start = brimful_start<2>();
    start.bodies[0].velocity.assign(start.bodies[0].points.size(), {0.5, 0.0});
    auto s = make_simulation<2, double>(start);
    const auto before = take_ledger(s);
    while (s.time < 1.0) advance(s, stable_time_step(s));
    const auto after = take_ledger(s);
    CHECK(s.accounts.outflow.mass > 0.05 * before.mass);
    CHECK(after.mass + s.accounts.outflow.mass == doctest::Approx(before.mass).epsilon(1e-12));
    Vector<2, double> open =
        after.momentum + s.accounts.outflow.momentum - before.momentum - s.accounts.wall_impulse;
    open[1] -= s.accounts.gravity_impulse;
    // What leaves takes along velocities that the nodes share with what stays: APIC's exchange in one step.
    CHECK(open.norm() < 1e-3 * before.momentum.norm());
}
