#include "mpm/grid/mirror.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "mpm/state/ledger.h"
#include "support/box.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int D>
using Corner = std::array<Mirror, static_cast<std::size_t>(D)>;

// A box whose walls at the origin, or all at the far end, mirror so.
template <int D>
Layout<D> mirrored_box(const Corner<D>& rules, std::size_t side) {
    Layout<D> layout;
    layout.cells.fill(3 * Block<D>::width + 2);
    for (std::size_t axis = 0; axis < D; ++axis) layout.mirrors[axis][side] = rules[axis];
    return layout;
}

// The block in the corner of that box: its nodes begin on the origin, or two nodes before the far walls.
template <int D>
Index<D> corner_block(std::size_t side) {
    Index<D> block;
    block.fill(side == 0 ? 2 : 5);
    return block;
}

template <int D>
std::vector<Node<double>> random_tile() {
    std::vector<Node<double>> tile(Block<D>::tile_size);
    for (std::size_t n = 0; n < tile.size(); ++n) {
        for (std::size_t lane = 0; lane < 4; ++lane)
            tile[n][static_cast<int>(lane)] = random_uniform(5, lane, n) + (lane == 3 ? 0.1 : -0.5);
    }
    return tile;
}

// Where a node of the tile lies, and whence its image: at once for all axes.
template <int D>
struct Reflection {
    int image = 0;
    bool beyond = false;  // just beyond a mirror
    Node<double> sign = Node<double>::Ones();
};

template <int D>
Reflection<D> reflection(const Layout<D>& layout, const Index<D>& block, int n) {
    Reflection<D> r;
    for (int axis = D - 1, stride = 1; axis >= 0; --axis, stride *= Block<D>::tile_width) {
        const auto a = static_cast<std::size_t>(axis);
        int at = n / stride % Block<D>::tile_width - 1 + layout.first_node(block[a]);
        for (const int side : {0, 1}) {
            const Mirror mirror = layout.mirrors[a][static_cast<std::size_t>(side)];
            const int plane = side == 0 ? 0 : layout.cells[a], depth = side == 0 ? -at : at - plane;
            if (mirror == Mirror::none || depth != 1) continue;
            r.beyond = true;
            at = 2 * plane - at;
            if (mirror == Mirror::stick) r.sign.template head<3>() *= -1.0;
            if (mirror == Mirror::slip) r.sign[axis] *= -1.0;
        }
        r.image += stride * (at + 1 - layout.first_node(block[a]));
    }
    return r;
}

template <int D>
Vector<D, double> momentum_part(const Node<double>& node) {
    return node.template head<D>().matrix();
}

template <int D>
void check_corner(const Corner<D>& rules, std::size_t side) {
    const Layout<D> layout = mirrored_box<D>(rules, side);
    const Index<D> block = corner_block<D>(side);
    CHECK(has_mirror<D>(layout, block));
    const auto raw = random_tile<D>();
    auto expected = raw;
    Vector<D, double> given = Vector<D, double>::Zero();
    for (int n = 0; n < Block<D>::tile_nodes; ++n) {
        const auto r = reflection<D>(layout, block, n);
        if (!r.beyond) continue;
        const auto at = static_cast<std::size_t>(n);
        expected[static_cast<std::size_t>(r.image)] += r.sign * raw[at];
        expected[at].setZero();
        given += momentum_part<D>(r.sign * raw[at] - raw[at]);
    }
    auto folded = raw;
    const auto impulse = fold<D, double>(layout, block, Parity::velocity, folded.data());
    CHECK((impulse - given).norm() < 1e-12);
    double mass = 0.0;
    for (int n = 0; n < Block<D>::tile_nodes; ++n) {
        const auto at = static_cast<std::size_t>(n);
        const bool beyond = reflection<D>(layout, block, n).beyond;
        CHECK(folded[at][mass_lane] == doctest::Approx(expected[at][mass_lane]).epsilon(1e-14));
        if (!beyond) CHECK((folded[at] - expected[at]).matrix().norm() < 1e-14);
        mass += folded[at][mass_lane] - raw[at][mass_lane];
    }
    CHECK(std::abs(mass) < 1e-12);

    auto velocity = random_tile<D>();
    const auto before = velocity;
    unfold<D, double>(layout, block, Parity::velocity, velocity.data());
    Vector<D, double> taken = Vector<D, double>::Zero();
    for (int n = 0; n < Block<D>::tile_nodes; ++n) {
        const auto r = reflection<D>(layout, block, n);
        const auto& image = before[static_cast<std::size_t>(r.image)];
        const auto& now = velocity[static_cast<std::size_t>(n)];
        CHECK((now == r.sign * image).all());
        if (r.beyond) taken += raw[static_cast<std::size_t>(n)][mass_lane] * momentum_part<D>(now - image);
    }
    const auto unfolding = unfolding_impulse<D, double>(layout, block, velocity.data(), folded.data());
    CHECK((unfolding - taken).norm() < 1e-12);
}

// The least distance of particles from the sides of their box, in cells; negative outside.
template <int D, class Real>
double depth_beyond_walls(const Simulation<D, Real>& s) {
    double least = 1e9;
    for (const auto& x : test::read_state(s).x) {
        for (int axis = 0; axis < D; ++axis) {
            const double cells = x[axis] / s.grid.layout.cell_size;
            const double size = s.grid.layout.cells[static_cast<std::size_t>(axis)];
            least = std::min({least, cells, size - cells});
        }
    }
    return least;
}

// Disordered water, thrown against the left wall and the bottom.
template <int D>
Start<D> thrown_water(WallRule rule) {
    Index<D> cells;
    cells.fill(D == 2 ? 20 : 9);
    auto start =
        test::tank_start<D>(0.05, cells, D == 2 ? 0.5 : 0.3, 20.0, 0.0, Vector<D, double>::Zero(), 2, 0.8);
    for (auto& axis : start.parameters.boundaries.walls) axis = {rule, rule};
    start.bodies[0].velocity.assign(start.bodies[0].points.size(), Vector<D, double>::Constant(-2.0));
    return start;
}

}  // namespace

TEST_CASE("a tile folds and unfolds at the corners of a box as its nodes' images say") {
    for (const std::size_t side : {0u, 1u}) {
        check_corner<2>({Mirror::slip, Mirror::slip}, side);
        check_corner<2>({Mirror::stick, Mirror::stick}, side);
        check_corner<2>({Mirror::stick, Mirror::slip}, side);
        check_corner<2>({Mirror::none, Mirror::slip}, side);
        check_corner<3>({Mirror::slip, Mirror::slip, Mirror::slip}, side);
        check_corner<3>({Mirror::stick, Mirror::stick, Mirror::stick}, side);
        check_corner<3>({Mirror::slip, Mirror::none, Mirror::stick}, side);
    }
}

TEST_CASE("scalars are even about every wall, and tiles away from mirrors stay as they are") {
    const auto layout = mirrored_box<2>({Mirror::slip, Mirror::stick}, 0);
    auto tile = random_tile<2>();
    unfold<2, double>(layout, {2, 2}, Parity::even, tile.data());
    constexpr auto width = static_cast<std::size_t>(Block<2>::tile_width);
    CHECK((tile[0] == tile[2 * width + 2]).all());
    for (const Index<2>& block : {Index<2>{3, 3}, Index<2>{5, 4}}) {
        const auto raw = random_tile<2>();
        auto copy = raw;
        CHECK(!has_mirror<2>(layout, block));
        CHECK(fold<2, double>(layout, block, Parity::velocity, copy.data()).isZero());
        unfold<2, double>(layout, block, Parity::velocity, copy.data());
        for (std::size_t n = 0; n < raw.size(); ++n) CHECK((copy[n] == raw[n]).all());
    }
}

TEST_CASE("slip and stick walls mirror, walls that separate and the one that a push replaces do not") {
    Boundaries<2> boundaries;
    boundaries.walls[0] = {WallRule::slip, WallRule::stick};
    boundaries.walls[1] = {WallRule::separate, WallRule::slip};
    auto mirrors = mirrors_of(boundaries);
    CHECK(mirrors == Mirrors<2>{{{Mirror::slip, Mirror::stick}, {Mirror::none, Mirror::slip}}});
    boundaries.push.speed = 1.0;
    mirrors = mirrors_of(boundaries);
    CHECK(mirrors[0][0] == Mirror::none);
    CHECK(mirrors[0][1] == Mirror::stick);
}

TEST_CASE("water before a slip wall moves as if its mirror image were there instead of the wall") {
    constexpr int plane = 18;  // within a block: the wall is at the far end of the half tank
    auto half = test::tank_start<2>(0.1, {plane, 20}, 1.0, 20.0, 0.0, Vector<2, double>::Zero(), 2, 0.8);
    auto whole = half;
    whole.cells[0] = 2 * plane;
    auto& image = whole.bodies[0];
    const double twice = 2 * plane * 0.1;
    for (std::size_t n = 0; n < half.bodies[0].points.size(); ++n) {
        const Vector<2, double> x = half.bodies[0].points[n], v(0.0, 1.0 - x[0]);
        half.bodies[0].velocity.push_back(v);
        image.velocity.push_back(v);
    }
    for (std::size_t n = 0, count = image.points.size(); n < count; ++n) {
        image.points.emplace_back(twice - image.points[n][0], image.points[n][1]);
        image.velocity.emplace_back(-image.velocity[n][0], image.velocity[n][1]);
    }
    image.mass *= 2.0;
    image.volume *= 2.0;
    auto a = make_simulation<2, double>(half);
    auto b = make_simulation<2, double>(whole);
    for (int n = 0; n < 300; ++n) {
        advance(a, 2e-3);
        advance(b, 2e-3);
    }
    const auto one = test::read_state(a), both = test::read_state(b);
    double most = 0.0, moved = 0.0;
    for (std::size_t p = 0; p < one.x.size(); ++p) {
        most = std::max(most, (one.x[p] - both.x[p]).norm());
        moved = std::max(moved, (one.x[p] - half.bodies[0].points[p]).norm());
    }
    CHECK(moved > 0.1);
    CHECK(most < 1e-10);
}

TEST_CASE_TEMPLATE("thrown against mirrors water does not pass them, and its momentum is accounted for",
                   Engine, TIDEWATER_ENGINES) {
    constexpr int D = Engine::D;
    for (const WallRule rule : {WallRule::slip, WallRule::stick}) {
        auto s = make_simulation<D, typename Engine::Real>(thrown_water<D>(rule));
        const auto before = take_ledger(s);
        double least = 1e9;
        for (int n = 0; n < (D == 2 ? 2000 : 400); ++n) {
            advance(s, stable_time_step(s));
            if (n % 20 == 0) least = std::min(least, depth_beyond_walls(s));
        }
        test::check_momentum(s, before.momentum,
                             std::abs(s.accounts.gravity_impulse) + before.momentum.norm());
        CHECK(s.accounts.wall_impulse.norm() > 0.5 * before.momentum.norm());
        CHECK(least > -1e-6);
        MESSAGE("nearest to a wall, cells: " << least);
    }
}
