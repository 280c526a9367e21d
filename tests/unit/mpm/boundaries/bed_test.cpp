#include "mpm/boundaries/bed.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "mpm/state/ledger.h"
#include "support/state.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// Heights at every node line along x, the same for all y.
template <int D, class Height>
Bed<D> make_bed(double cell_size, const Index<D>& cells, const Height& height, const GroundRule& rule = {}) {
    Bed<D> bed;
    bed.rule = rule;
    bed.spacing = cell_size;
    bed.points.fill(1);
    bed.points[0] = cells[0] + 1;
    for (int n = 0; n <= cells[0]; ++n) bed.heights.push_back(height(n * cell_size));
    return bed;
}

// Fills a start with water wherever inside(point) holds.
template <int D, class Inside>
Start<D> water_start(double cell_size, const Index<D>& cells, double sound_speed, double jitter,
                     const Inside& inside) {
    Start<D> start;
    start.cell_size = cell_size;
    start.cells = cells;
    start.parameters.water.sound_speed = sound_speed;
    auto& water = start.bodies.emplace_back();
    water.points = test::lattice<D>(cell_size, cells, 2, jitter, inside);
    water.volume = std::pow(0.5 * cell_size, D) * static_cast<double>(water.points.size());
    water.mass = start.parameters.water.density * water.volume;
    return start;
}

// Acceleration along a slope of `angle` of a ball's centre of mass over g sin(angle), from its velocities
// between two times. The ball starts in contact, `cells_across` cells in diameter, with walls far away.
template <int D>
double slide(double angle, int cells_across) {
    const double slope = std::tan(angle), down = slope < 0.0 ? 1.0 : -1.0;  // along x
    const double diameter = 1.0, cell = diameter / cells_across;
    Index<D> cells;
    cells.fill(2 * cells_across);
    cells[0] = 6 * cells_across;
    const double foot = 0.2371, length = cell * cells[0];
    const auto height = [&](double x) { return foot + std::abs(slope) * (down > 0.0 ? length - x : x); };
    cells[D - 1] = static_cast<int>(std::ceil((height(down > 0.0 ? 0.0 : length) + 1.5) / cell));
    Vector<D, double> center = Vector<D, double>::Constant(diameter);
    center[0] = down > 0.0 ? 0.4 * length : 0.6 * length;
    center[D - 1] = height(center[0]) + 0.5 * diameter / std::cos(angle);
    auto start = water_start<D>(cell, cells, 30.0, 0.0,
                                [&](const auto& point) { return (point - center).norm() < 0.5 * diameter; });
    start.parameters.boundaries.bed = make_bed<D>(cell, cells, height);
    auto s = make_simulation<D, double>(start);
    const auto along = [&] {
        const auto ledger = take_ledger(s);
        return (down * ledger.momentum[0] * std::cos(angle) -
                ledger.momentum[D - 1] * std::abs(std::sin(angle))) /
               ledger.mass;
    };
    while (s.time < 0.1) advance(s, stable_time_step(s));
    const double from = along(), time = s.time + 0.5 * s.dt;
    while (s.time < 0.25) advance(s, stable_time_step(s));
    CHECK(s.accounts.wall_impulse[D - 1] >
          0.1 * std::abs(s.accounts.gravity_impulse));  // it does touch the ground
    return (along() - from) / ((s.time + 0.5 * s.dt - time) * 9.81 * std::abs(std::sin(angle)));
}

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

}  // namespace

TEST_CASE("a bed's height is bilinear between its points and level beyond them") {
    Bed<3> bed;
    bed.spacing = 2.0;
    bed.points = {3, 2};
    bed.heights = {0.0, 4.0, 1.0, 5.0, 3.0, 9.0};
    CHECK(bed.height({0.0, 0.0}) == 0.0);
    CHECK(bed.height({4.0, 2.0}) == 9.0);
    CHECK(bed.height({1.0, 1.0}) == doctest::Approx(2.5));
    CHECK(bed.height({3.0, 0.5}) == doctest::Approx(0.75 * 2.0 + 0.25 * 7.0));
    CHECK(bed.height({-1.0, 9.0}) == 4.0);
    CHECK(bed.height({99.0, -9.0}) == 3.0);
    const auto slope = bed.slope({1.0, 1.0}, 0.5);
    CHECK(slope[0] == doctest::Approx(0.5));
    CHECK(slope[1] == doctest::Approx(2.0));
    Bed<2> level;
    level.spacing = 1.0;
    level.points = {1};
    level.heights = {3.0};
    CHECK(level.height(Vector<1, double>(7.0)) == 3.0);
    CHECK(!Bed<2>{}.exists());
}

TEST_CASE("a bed takes what goes into the ground along its own normal, and says its impulse") {
    const Layout<2> layout{0.5, {32, 32}};
    const auto act = [&](const GroundRule& rule, const Vector<2, double>& v, WallAction<2>& action) {
        const auto bed = make_bed<2>(
            0.5, layout.cells, [](double x) { return 0.3 + 0.75 * x; }, rule);
        std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(v[0], v[1], 0.0, 2.0));
        const auto acting = bed.acting(layout, {});
        const auto under = acting.on({2, 2});
        REQUIRE(under.has_value());
        action.impulse =
            change_nodes<2, double>(NodeBox<2>::all(), nodes.data(), [&](int n, Node<double>& velocity) {
                under->act({.node = node_at<2>(layout, {2, 2}, n)}, velocity, action);
            });
        return nodes;
    };
    const auto at = [](const auto& nodes, int x, int z) -> Vector<2, double> {
        return nodes[static_cast<std::size_t>(x * Block<2>::width + z)].template head<2>().matrix();
    };
    const Vector<2, double> normal(-0.6, 0.8), along(0.8, 0.6);
    WallAction<2> action;
    // At x = 2 m, node 4, the ground is at 1.8 m; nodes up to 0.75 · 0.5/0.8 m above it are held: z ≤ 2.2 m.
    const auto pressed = act({}, -normal + 2.0 * along, action);
    CHECK(at(pressed, 4, 4).isApprox(2.0 * along));
    CHECK(at(pressed, 4, 5).isApprox(-normal + 2.0 * along));
    CHECK(action.impulse.dot(normal) > 0.0);
    const auto free = act({}, normal + 2.0 * along, action);
    CHECK(at(free, 4, 2).isApprox(normal + 2.0 * along));
    GroundRule held;
    held.holds_water = true;
    CHECK(at(act(held, normal, action), 4, 4).isZero());
    CHECK(action.work == 0.0);
    // In the corner with the wall the normal has no part into the wall.
    const auto falling = act({}, -normal, action);
    CHECK(at(falling, 0, 1).isApprox(Vector<2, double>(-normal[0], 0.0)));
}

TEST_CASE("a ball of water slides down a frictionless slope with g sin of its angle") {
    CHECK(slide<2>(radians(30.0), 10) == doctest::Approx(1.0).epsilon(0.01));
    CHECK(slide<2>(radians(-30.0), 10) == doctest::Approx(1.0).epsilon(0.01));
    CHECK(slide<2>(radians(30.0), 20) == doctest::Approx(1.0).epsilon(0.01));
    for (const double angle : {7.0, 20.0, 45.0, 60.0}) {
        CAPTURE(angle);
        CHECK(slide<2>(radians(angle), 10) == doctest::Approx(1.0).epsilon(0.01));
    }
}

TEST_CASE("a sphere of water slides down a frictionless slope with g sin of its angle") {
    CHECK(slide<3>(radians(30.0), 8) == doctest::Approx(1.0).epsilon(0.01));
}

TEST_CASE("a pool in a valley stays where it is, whatever the slope and the cells it crosses") {
    for (const double slope : {0.3, 1.0, 1.4}) {
        for (const double foot : {0.113, 0.127}) {
            CAPTURE(slope);
            CAPTURE(foot);
            const double cell = 0.1, level = 1.2;
            const Index<2> cells{24, 16};
            const auto height = [&](double x) { return foot + slope * std::abs(x - 1.2); };
            auto start = water_start<2>(cell, cells, 40.0, 0.3, [&](const auto& point) {
                return point[1] < level && point[1] > height(point[0]);
            });
            start.bodies[0].surface = level;
            start.parameters.boundaries.bed = make_bed<2>(cell, cells, height);
            auto s = make_simulation<2, double>(start);
            const auto before = take_ledger(s);
            while (s.time < 2.0) advance(s, stable_time_step(s));
            const auto after = take_ledger(s);
            const double sunk = (before.gravitational - after.gravitational) / (9.81 * after.mass);
            CHECK(std::abs(sunk) < 0.1 * cell);
            CHECK(std::sqrt(2.0 * after.kinetic / after.mass) < 0.02);
            const auto state = test::read_state(s);
            double deepest = 0.0;
            for (const auto& x : state.x) deepest = std::min(deepest, (x[1] - height(x[0])) / cell);
            CHECK(deepest > -0.5);
            Vector<2, double> open = after.momentum - s.accounts.wall_impulse;
            open[1] -= s.accounts.gravity_impulse;
            CHECK(open.norm() < 1e-9 * std::abs(s.accounts.gravity_impulse));
        }
    }
}

// Were the bottom wall applied before the bed, the bed would turn what presses on the wall into motion along
// the slope: metres a second.
TEST_CASE("still water above a slope whose foot lies on the bottom wall stays still") {
    const double cell = 0.1, level = 1.0;
    const Index<2> cells{40, 16};
    for (const double foot : {2.0, 2.05}) {
        CAPTURE(foot);
        const auto height = [&](double x) { return std::max(0.0, 0.5 * (x - foot)); };
        auto start = water_start<2>(cell, cells, 40.0, 0.3, [&](const auto& point) {
            return point[1] < level && point[1] > height(point[0]);
        });
        start.bodies[0].surface = level;
        start.parameters.boundaries.bed = make_bed<2>(cell, cells, height);
        auto s = make_simulation<2, double>(start);
        double fastest = 0.0;
        while (s.time < 2.0) {
            advance(s, stable_time_step(s));
            fastest = std::max(fastest, s.speeds.particle);
        }
        const auto after = take_ledger(s);
        CHECK(fastest < 0.3);
        CHECK(std::sqrt(2.0 * after.kinetic / after.mass) < 0.02);
    }
}

TEST_CASE("a bed without heights, and one below all nodes, changes nothing") {
    auto start = test::tank_start<2>(0.1, {20, 10}, 0.5, 30.0);
    const auto run = [&] {
        auto s = make_simulation<2, float>(start);
        for (int n = 0; n < 50; ++n) advance(s, stable_time_step(s));
        return state_hash(s);
    };
    const auto plain = run();
    start.parameters.boundaries.bed = make_bed<2>(0.1, {20, 10}, [](double) { return -1.0; });
    CHECK(run() == plain);
}
