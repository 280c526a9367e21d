#include "mpm/step/spray.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mpm/state/ledger.h"
#include "support/state.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double cell = 0.1, depth = 1.0;  // m

// Water at rest, 1 m deep, and above it a drop of 1 or 2^d particles with its lower corner at `from` and this
// velocity. The drop's particles come last.
template <int D>
Start<D> drop_over_water(const Index<D>& cells, double sound_speed, const Vector<D, double>& from,
                         const Vector<D, double>& velocity, int across) {
    auto start = test::tank_start<D>(cell, cells, depth, sound_speed);
    auto& water = start.bodies[0];
    const double volume = water.volume / static_cast<double>(water.points.size());
    water.velocity.assign(water.points.size(), Vector<D, double>::Zero());
    const std::size_t still = water.points.size();
    for (int n = 0; n < power(across, D); ++n) {
        Vector<D, double> point = from;
        for (int axis = 0; axis < D; ++axis) point[axis] += 0.5 * cell * index_along<D>(n, across, axis);
        water.points.push_back(point);
        water.velocity.push_back(velocity);
    }
    for (const auto& point : water.points) water.head.push_back(std::max(depth - point[D - 1], 0.0));
    const double added = volume * static_cast<double>(water.points.size() - still);
    water.volume += added;
    water.mass += added * start.parameters.water.density;
    return start;
}

template <int D>
Index<D> tank_cells(int length, int height) {
    Index<D> cells;
    cells.fill(6);
    cells[0] = length;
    cells[D - 1] = height;
    return cells;
}

}  // namespace

TEST_CASE_TEMPLATE("a drop thrown at 45 degrees lands where a stone would, and gives the water what it had",
                   Dimension, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const double speed = 4.0, up = speed * std::sqrt(0.5);
    Vector<D, double> from = Vector<D, double>::Constant(0.325), velocity = Vector<D, double>::Zero();
    from[D - 1] = depth + 0.5;
    velocity[0] = velocity[D - 1] = up;
    const auto start = drop_over_water<D>(tank_cells<D>(28, 22), 40.0, from, velocity, 1);
    const std::size_t drop = start.bodies[0].points.size() - 1;
    auto s = make_simulation<D, float>(start);
    const Vector<D, double> momentum = take_ledger(s).momentum;
    const double flight = (up + std::sqrt(up * up + 2.0 * 9.81 * 0.5)) / 9.81, place = from[0] + up * flight;
    double touched = 0.0;
    while (s.time < flight + 0.4) {
        advance(s, stable_time_step(s));
        const auto state = test::read_state(s);
        if (touched == 0.0 && state.x[drop][D - 1] < depth + 1.5 * cell) touched = state.x[drop][0];
    }
    const auto state = test::read_state(s);
    CHECK(std::abs(touched - place) < 2.0 * cell);
    CHECK(std::abs(state.x[drop][0] - place) < 2.0 * cell);
    CHECK(state.x[drop][D - 1] < depth + 1.5 * cell);  // where kernels reach each other
    CHECK(state.v[drop].norm() < 0.1 * speed);
    Vector<D, double> open = take_ledger(s).momentum - momentum - s.accounts.wall_impulse;
    open[D - 1] -= s.accounts.gravity_impulse;
    CHECK(open.norm() < 1e-6 * std::abs(s.accounts.gravity_impulse));
}

TEST_CASE("a drop that flies along still water is not carried by it") {
    // A group of four particles, two cells up: as large as it may be without bearing pressure. Bearing it, it
    // was 39 cells on after 0.66 s and still at 0.8 of its speed.
    const auto start = drop_over_water<2>({80, 30}, 37.0, {1.025, depth + 0.2}, {6.6, 0.0}, 2);
    const std::size_t drop = start.bodies[0].points.size() - 1;
    auto s = make_simulation<2, float>(start);
    while (s.time < 0.66) advance(s, stable_time_step(s));
    const auto state = test::read_state(s);
    MESSAGE("it comes ", (state.x[drop][0] - 1.075) / cell, " cells and has ", state.v[drop][0], " m/s left");
    CHECK(state.x[drop][0] < 1.075 + 25.0 * cell);
    CHECK(state.v[drop][0] < 0.1 * 6.6);
}

TEST_CASE_TEMPLATE("only water without neighbours is opened: no surface, wall or corner of a body of water",
                   Dimension, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const double height : {depth + 0.005, depth + 0.03, depth + 0.055}) {  // of the surface on the grid
        auto start = test::tank_start<D>(cell, tank_cells<D>(12, 22), height, 40.0, 0.0,
                                         Vector<D, double>::Zero(), 2, 0.2);
        start.bodies[0].points.push_back(Vector<D, double>::Constant(0.317));
        start.bodies[0].points.back()[D - 1] = 1.83;
        start.bodies[0].head.clear();
        for (const auto& point : start.bodies[0].points)
            start.bodies[0].head.push_back(std::max(height - point[D - 1], 0.0));
        const std::size_t drop = start.bodies[0].points.size() - 1;
        auto s = make_simulation<D, double>(start);
        for (int n = 0; n < 3; ++n) advance(s, stable_time_step(s));
        auto& water = s.bodies[0];
        for (std::size_t p = 0; p < water.size(); ++p) {
            if (water.id[p] == drop) water.j[p] = -0.25;
        }
        const auto before = water.j;
        open_spray(s.parameters.water, s.grid, s.rigid, s.bodies);
        long opened = 0;
        for (std::size_t p = 0; p < water.size(); ++p) {
            if (water.id[p] == drop)
                CHECK(water.j[p] == lone_opening);
            else
                opened += water.j[p] != before[p];
        }
        CHECK(opened == 0);
    }
}
