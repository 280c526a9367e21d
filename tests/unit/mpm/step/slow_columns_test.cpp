#include "mpm/step/slow_columns.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mpm/state/ledger.h"
#include "mpm/step/nodes.h"
#include "support/mixed_tank.h"
#include "support/rough_ground.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// A tank whose water, a metre deep over ground at 0.3 m, streams at 2 m/s along x.
template <int D>
Start<D> stream(const DragLaw& drag) {
    Index<D> cells;
    cells.fill(8);
    cells[0] = 20;
    cells[D - 1] = 16;
    auto start = test::tank_start<D>(0.1, cells, 1.3, 30.0);
    std::erase_if(start.bodies[0].points, [](const auto& x) { return x[D - 1] < 0.3; });
    start.bodies[0].volume = std::pow(0.05, D) * static_cast<double>(start.bodies[0].points.size());
    start.bodies[0].mass = 1000.0 * start.bodies[0].volume;
    start.parameters.water.density = 1000.0;
    start.bodies[0].velocity.assign(start.bodies[0].points.size(), 2.0 * Vector<D, double>::Unit(0));
    test::lay_bed<D>([](double) { return 0.3; }, {}, start);
    start.parameters.boundaries.drag.bed = drag;
    return start;
}

template <int D>
std::vector<double> slowing(const Simulation<D, double>& s, double dt) {
    BoundaryStep step;
    step.dt = dt;
    return slow_columns<D, double>(s.parameters, step, Slots::all(s.grid.node_blocks.size()), {}, s.grid);
}

}  // namespace

TEST_CASE_TEMPLATE("drag slows a stream by C u dt/h, implicitly, in every column", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const auto check = [](const DragLaw& law, double coefficient) {
        const auto s = make_simulation<D, double>(stream<D>(law));
        const double dt = 0.5, share = coefficient * 2.0 * dt / 1.0;
        const auto slower = slowing(s, dt);
        const Columns<D> columns(s.grid.layout);
        REQUIRE(slower.size() == D * columns.size());
        for (int x = 0; x <= 20; ++x) {
            CAPTURE(x);
            Index<D - 1> column{};
            column[0] = x;
            if (D == 3) column[D - 2] = D == 3 ? std::min(x, 8) : x;
            if (D == 2) column[0] = x;
            const std::size_t place = *columns.place(column);
            // The water starts compressed by its weight, a little more than a metre's mass.
            CHECK(slower[place * D] == doctest::Approx(2.0 * share / (1.0 + share)).epsilon(0.01));
            CHECK(slower[place * D + D - 1] == doctest::Approx(0.0).epsilon(1e-12));
        }
    };
    DragLaw law;
    law.coefficient = 0.02;
    check(law, 0.02);
    law = {};
    law.manning = 0.04;
    check(law, 9.81 * 0.04 * 0.04);  // h is 1 m
}

TEST_CASE("drag's impulse and work are booked, and the stream turns no way round") {
    DragLaw law;
    law.coefficient = 0.05;
    auto s = make_simulation<2, double>(stream<2>(law));
    s.parameters.boundaries.walls[0] = {WallRule::separate, WallRule::separate};
    const auto before = take_ledger(s);
    for (int n = 0; n < 100; ++n) advance(s, stable_time_step(s));
    const auto after = take_ledger(s);
    Vector<2, double> open = after.momentum - before.momentum - s.accounts.wall_impulse;
    open[1] -= s.accounts.gravity_impulse;
    CHECK(open.norm() < 1e-12 * before.momentum.norm());
    CHECK(s.accounts.drag_work < 0.0);
    CHECK(s.accounts.friction_work == 0.0);
}

TEST_CASE("ice in a column is not slowed, nor is water without drag's key") {
    auto start = test::on_rough_ground(test::mixed_tank<2>());
    auto s = make_simulation<2, double>(start);
    for (int n = 0; n < 20; ++n) advance(s, stable_time_step(s));
    CHECK(s.accounts.drag_work != 0.0);
    start.parameters.boundaries.drag = {};
    start.rigid.clear();
    auto glides = make_simulation<2, double>(start);
    for (int n = 0; n < 20; ++n) advance(glides, stable_time_step(glides));
    CHECK(glides.accounts.drag_work == 0.0);
}
