#include "mpm/boundary.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <vector>

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// Walls' effect on a 2D block whose nodes all have mass 2 and this velocity.
std::vector<Node<double>> walled(WallRule rule, const Index<2>& block, double vx, double vz,
                                 WallAction<2>& action) {
    const Layout<2> layout{0.5, {32, 20}};
    std::vector<Node<double>> nodes(Block<2>::nodes, Node<double>(vx, vz, 0.0, 2.0));
    Walls<2> walls;
    for (auto& axis : walls) axis = {rule, rule};
    action = apply_walls<2, double>(layout, walls, block, nodes.data());
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
    CHECK(apply_walls<2, double>(layout, {}, {2, 2}, nodes.data()).impulse.isZero());
}
