#include "mpm/boundaries/boundaries.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// What the boundaries do to a block at a time, or before time begins.
WallAction<2> apply(const Layout<2>& layout, const Boundaries<2>& boundaries, std::optional<double> time,
                    const Index<2>& block, std::vector<Node<double>>& nodes) {
    BoundaryStep step;
    step.time = time;
    step.left_wall_moves = replaces_left_wall(boundaries);
    return apply_boundaries<2, double>(layout, acting_boundaries(layout, boundaries, step), block, {},
                                       nullptr, nodes.data());
}

// Walls' effect on a 2D block whose nodes all have mass 2 and this velocity.
std::vector<Node<double>> walled(WallRule rule, const Index<2>& block, double vx, double vz,
                                 WallAction<2>& action) {
    const Layout<2> layout{0.5, {32, 20}};
    std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(vx, vz, 0.0, 2.0));
    Boundaries<2> boundaries;
    for (auto& axis : boundaries.walls) axis = {rule, rule};
    action = apply(layout, boundaries, 0.0, block, nodes);
    return nodes;
}

const Node<double>& at(const std::vector<Node<double>>& nodes, int x, int z) {
    return nodes[static_cast<std::size_t>(x * Block<2>::width + z)];
}

}  // namespace

TEST_CASE("slip walls stop the normal velocity both ways and keep the other") {
    WallAction<2> action;
    const auto nodes =
        walled(WallRule::slip, {2, 3}, 1.0, -1.0, action);  // nodes x = 0…15, z = 16…31; top wall at 20
    CHECK(at(nodes, 0, 0).isApprox(Node<double>(0.0, -1.0, 0.0, 2.0)));
    CHECK(at(nodes, 3, 4).isApprox(Node<double>(1.0, 0.0, 0.0, 2.0)));
    CHECK(at(nodes, 0, 4).isApprox(Node<double>(0.0, 0.0, 0.0, 2.0)));
    CHECK(at(nodes, 3, 3).isApprox(Node<double>(1.0, -1.0, 0.0, 2.0)));
    // 16 nodes of the left wall's column lose 2 kg m/s along x; the rows z = 20…31, 16 nodes each, gain 2
    // along z.
    CHECK(action.impulse[0] == doctest::Approx(-32.0));
    CHECK(action.impulse[1] == doctest::Approx(384.0));
}

TEST_CASE("separate walls let go of what moves away") {
    WallAction<2> action;
    const auto nodes = walled(WallRule::separate, {2, 3}, 1.0, 1.0, action);
    CHECK(at(nodes, 0, 0)[0] == 1.0);  // away from the left wall
    CHECK(at(nodes, 0, 4)[1] == 0.0);  // into the top
    const auto pushed = walled(WallRule::separate, {2, 2}, -1.0, -1.0, action);
    CHECK(at(pushed, 0, 0)[0] == 0.0);
    CHECK(at(pushed, 0, 0)[1] == 0.0);
}

TEST_CASE("stick walls stop everything, and blocks without a wall are left alone") {
    WallAction<2> action;
    CHECK(at(walled(WallRule::stick, {2, 2}, 3.0, 2.0, action), 0, 5).head<2>().isZero());
    const auto inner = walled(WallRule::stick, {3, 2}, 3.0, 2.0, action);
    CHECK(at(inner, 4, 4).isApprox(Node<double>(3.0, 2.0, 0.0, 2.0)));
}

TEST_CASE("nodes without mass get no impulse") {
    const Layout<2> layout{0.5, {32, 20}};
    std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(1.0, 1.0, 0.0, 0.0));
    CHECK(apply(layout, {}, 0.0, {2, 2}, nodes).impulse.isZero());
}

TEST_CASE(
    "a shelf carries what presses on its top, lets go of what leaves it, and its front keeps water out") {
    const Layout<2> layout{1.0, {32, 32}};
    Boundaries<2> boundaries;
    boundaries.shelf.end = 6.0;
    boundaries.shelf.top = 4.0;
    const auto act = [&](double vx, double vz) {
        std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(vx, vz, 0.0, 2.0));
        apply(layout, boundaries, 0.0, {2, 2}, nodes);
        return nodes;
    };
    const auto pressed = act(-1.0, -1.0);
    CHECK(at(pressed, 3, 4).isApprox(Node<double>(-1.0, 0.0, 0.0, 2.0)));  // on top: slides freely
    CHECK(at(pressed, 3, 5).isApprox(Node<double>(-1.0, -1.0, 0.0, 2.0)));
    CHECK(at(pressed, 6, 2).isApprox(Node<double>(0.0, -1.0, 0.0, 2.0)));  // at the front
    CHECK(at(pressed, 7, 2).isApprox(Node<double>(-1.0, -1.0, 0.0, 2.0)));
    CHECK(at(pressed, 6, 4).isApprox(Node<double>(0.0, 0.0, 0.0, 2.0)));  // at the edge both
    const auto leaving = act(1.0, 1.0);
    CHECK(at(leaving, 3, 4).isApprox(Node<double>(1.0, 1.0, 0.0, 2.0)));
    CHECK(at(leaving, 6, 2).isApprox(Node<double>(1.0, 1.0, 0.0, 2.0)));
    boundaries.shelf.rule.holds_down = true;
    CHECK(at(act(1.0, 1.0), 3, 4).isApprox(Node<double>(1.0, 0.0, 0.0, 2.0)));
    CHECK(
        at(act(1.0, 1.0), 6, 4).isApprox(Node<double>(1.0, 1.0, 0.0, 2.0)));  // the edge lets go all the same
}

TEST_CASE("a shelf's top rubs ice and lets water glide, unless it is to hold it") {
    const Layout<2> layout{1.0, {32, 32}};
    Boundaries<2> boundaries;
    boundaries.shelf.end = 6.0;
    boundaries.shelf.top = 4.0;
    boundaries.shelf.rule.ice.friction = 0.5;
    const auto act = [&](Material matter) {
        std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(3.0, -2.0, 0.0, 2.0));
        BoundaryStep step;
        step.time = 0.0;
        const auto acting = acting_boundaries(layout, boundaries, step);
        CHECK(tells_matter<2>(acting, {2, 2}));
        CHECK_FALSE(tells_matter<2>(acting, {3, 2}));
        const auto action = apply_boundaries<2, double>(
            layout, acting, {2, 2}, {.all = matter, .ice = nullptr}, nullptr, nodes.data());
        CHECK((action.friction_work < 0.0) == (matter == Material::ice));
        return Vector<2, double>(at(nodes, 3, 4).head<2>().matrix());
    };
    CHECK(act(Material::ice).isApprox(Vector<2, double>(2.0, 0.0)));
    CHECK(act(Material::water).isApprox(Vector<2, double>(3.0, 0.0)));
    boundaries.shelf.rule.holds_water = true;
    CHECK(act(Material::water).isZero());
    CHECK(act(Material::ice).isApprox(Vector<2, double>(2.0, 0.0)));
}

TEST_CASE("a shelf that retreats lets go of one column of nodes after the other") {
    const Layout<2> layout{1.0, {32, 32}};
    Boundaries<2> boundaries;
    boundaries.shelf = {.end = 6.0, .top = 4.0, .rule = {}, .retreat = 0.5};
    const auto held = [&](std::optional<double> time, int x) {
        std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(0.0, -1.0, 0.0, 2.0));
        apply(layout, boundaries, time, {2, 2}, nodes);
        return at(nodes, x, 4)[1] == 0.0;
    };
    for (int x = 1; x <= 6; ++x) CHECK(held(0.0, x));
    CHECK(held(1.9, 5));
    CHECK_FALSE(held(1.9, 6));
    CHECK_FALSE(held(4.1, 4));
    CHECK(held(4.1, 3));
    CHECK(held({}, 6));  // before time begins it stands still
    CHECK(boundaries.shelf.end_at(2.0) == 5.0);
}

TEST_CASE("a push moves what lies behind it at its speed, holds nothing back and says its work") {
    const Layout<2> layout{1.0, {32, 32}};
    Boundaries<2> boundaries;
    boundaries.push = {2.0, 0.0};
    const auto act = [&](double vx, double time, WallAction<2>& action) {
        std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(vx, -1.0, 0.0, 3.0));
        action = apply(layout, boundaries, time, {2, 3}, nodes);
        return nodes;
    };
    WallAction<2> action;
    const auto pushed = act(0.5, 2.2, action);  // at x = 4.4
    for (int x = 0; x <= 5; ++x) CHECK(at(pushed, x, 3)[0] == 2.0);
    CHECK(at(pushed, 6, 3)[0] == 0.5);
    CHECK(at(pushed, 2, 3)[1] == -1.0);
    const double impulse = 6 * 16 * 3.0 * 1.5;
    CHECK(action.impulse[0] == doctest::Approx(impulse));
    CHECK(action.work == doctest::Approx(2.0 * impulse));
    CHECK(at(act(5.0, 2.2, action), 2, 3)[0] == 5.0);
    CHECK(action.work == 0.0);
}

TEST_CASE(
    "a push with a ramp starts and ends it without a jump in speed, and its place is the integral of that") {
    const Push push{3.0, 8.0};
    double x = 0.0, before = 0.0;
    const double dt = 1e-3;
    for (int n = 0; n < 12000; ++n) {
        const double v = push.velocity((n + 0.5) * dt);
        CHECK(std::abs(v - before) <= 1.01 * dt * 0.5 * 3.0 * 3.1416 / 8.0);
        before = v;
        x += v * dt;
        CHECK(push.position((n + 1) * dt) == doctest::Approx(x).epsilon(1e-5));
    }
    CHECK(push.velocity(8.0) == 3.0);
    CHECK(push.velocity(-1.0) == 0.0);
}

TEST_CASE("a boundary that leaves nodes out changes none of them") {
    const Layout<2> layout{0.5, {70, 40}};
    Boundaries<2> boundaries;
    for (auto& axis : boundaries.walls) axis = {WallRule::slip, WallRule::separate};
    boundaries.shelf.end = 6.2;
    boundaries.shelf.top = 3.4;
    boundaries.sponge = {.from = 20.3, .width = 10.0, .rate = 2.0};
    boundaries.bed.spacing = layout.cell_size;
    boundaries.bed.points = {layout.cells[0] + 1};
    for (int n = 0; n <= layout.cells[0]; ++n) boundaries.bed.heights.push_back(0.3 + 0.055 * n);
    BoundaryStep step;
    step.time = 0.0;
    step.dt = 0.1;
    const auto acting = acting_boundaries(layout, boundaries, step);
    int narrowed = 0;
    for (int n = 0; n < 7 * 5; ++n) {
        const Index<2> block{1 + n / 5, 1 + n % 5};
        const auto check = [&](const auto& boundary) {
            const auto here = boundary.on(block);
            if (!here) return;
            if constexpr (requires(NodeBox<2> box) { here->narrow(block, box); }) {
                NodeBox<2> box = NodeBox<2>::all();
                here->narrow(block, box);
                std::vector<bool> within(Block<2>::nodes, false);
                box.for_each_run([&](int first, int count) {
                    for (int node = first; node < first + count; ++node)
                        within[static_cast<std::size_t>(node)] = true;
                });
                WallAction<2> action;
                for (int node = 0; node < Block<2>::nodes; ++node) {
                    Node<double> velocity(0.7, -0.4, 0.0, 2.0);
                    here->act({.node = node_at(layout, block, node)}, velocity, action);
                    const bool changed = (velocity != Node<double>(0.7, -0.4, 0.0, 2.0)).any();
                    CHECK_MESSAGE(!(changed && !within[static_cast<std::size_t>(node)]), "block ", block[0],
                                  " ", block[1], " node ", node);
                    narrowed += !within[static_cast<std::size_t>(node)];
                }
            }
        };
        std::apply([&](const auto&... boundary) { (check(boundary), ...); }, acting);
    }
    CHECK(narrowed > 1000);
}
