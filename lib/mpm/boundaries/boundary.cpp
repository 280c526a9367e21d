#include "mpm/boundaries/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tidewater::mpm {
namespace {

template <int D>
bool replaces_left_wall(const Boundaries<D>& boundaries) {
    return boundaries.push.exists() || boundaries.piston.exists();
}

// The velocity at a wall of the given axis; `outward` is −1 at the origin's wall and +1 at the far one.
template <int D, class Real>
void apply_rule(WallRule rule, int axis, int outward, Node<Real>& velocity) {
    switch (rule) {
        case WallRule::stick:
            velocity.template head<D>().setZero();
            break;
        case WallRule::slip:
            velocity[axis] = Real(0);
            break;
        case WallRule::separate:
            velocity[axis] =
                outward < 0 ? std::max(velocity[axis], Real(0)) : std::min(velocity[axis], Real(0));
            break;
    }
}

// The boundaries at one time, in cells: nodes up to these numbers are on or behind them.
template <int D>
struct Limits {
    const Boundaries<D>& of;
    static constexpr int none = std::numeric_limits<int>::min() / 2;  // below any node
    int shelf_end = none, shelf_top = none;                           // nodes up to both lie in the shelf
    int pushed = none;                                                // as along x
    double push_velocity = 0.0;

    Limits(const Layout<D>& layout, const Boundaries<D>& boundaries, double time) : of(boundaries) {
        const auto node = [&](double x) { return static_cast<int>(std::floor(x / layout.cell_size + 1e-6)); };
        if (of.shelf.exists()) {
            shelf_end = node(of.shelf.end_at(time));
            shelf_top = node(of.shelf.top);
        }
        if (of.push.exists()) {
            pushed = node(of.push.position(time)) + 1;  // else what it pushes coasts between two nodes
            push_velocity = of.push.velocity(time);
        }
    }
};

// Whether any of them reaches into the block.
template <int D>
bool reaches_block(const Layout<D>& layout, const Limits<D>& limits, const Index<D>& block) {
    for (std::size_t axis = 0; axis < D; ++axis) {
        const int first = layout.first_node(block[axis]);
        if (first <= 0 || first + Block<D>::width > layout.cells[axis]) return true;
    }
    const int x = layout.first_node(block[0]), z = layout.first_node(block[D - 1]);
    return x <= limits.pushed || (x <= limits.shelf_end && z <= limits.shelf_top);
}

template <int D, class Real>
void apply_walls(const Layout<D>& layout, const Limits<D>& limits, const Index<D>& node,
                 Node<Real>& velocity) {
    for (std::size_t axis = 0; axis < D; ++axis) {
        const bool replaced = axis == 0 && replaces_left_wall(limits.of);
        const auto& [near, far] = limits.of.walls[axis];
        if (node[axis] <= 0 && !replaced) apply_rule<D>(near, static_cast<int>(axis), -1, velocity);
        if (node[axis] >= layout.cells[axis]) apply_rule<D>(far, static_cast<int>(axis), 1, velocity);
    }
}

// The nearer of the shelf's two faces acts; both at its edge, where the top holds only what presses down on
// it.
template <int D, class Real>
void apply_shelf(const Limits<D>& limits, const Index<D>& node, Node<Real>& velocity) {
    const int below_top = limits.shelf_top - node[D - 1], behind_front = limits.shelf_end - node[0];
    if (below_top < 0 || behind_front < 0) return;
    if (below_top <= behind_front) {
        const bool edge = below_top == behind_front;
        apply_rule<D>(edge ? WallRule::separate : limits.of.shelf.rule, D - 1, -1, velocity);
    }
    if (behind_front <= below_top) apply_rule<D>(WallRule::separate, 0, -1, velocity);
}

}  // namespace

double Shelf::end_at(double time) const { return end - retreat * std::max(time, 0.0); }

double Push::velocity(double time) const {
    if (time >= 0.0 && time >= ramp) return speed;
    return time <= 0.0 ? 0.0 : 0.5 * speed * (1.0 - std::cos(std::numbers::pi * time / ramp));
}

double Push::position(double time) const {
    if (time >= 0.0 && time >= ramp) return speed * (time - 0.5 * ramp);
    if (time <= 0.0) return 0.0;
    return 0.5 * speed * (time - ramp / std::numbers::pi * std::sin(std::numbers::pi * time / ramp));
}

template <int D>
Mirrors<D> mirrors_of(const Boundaries<D>& boundaries) {
    Mirrors<D> mirrors{};
    for (std::size_t axis = 0; axis < D; ++axis) {
        for (std::size_t side = 0; side < 2; ++side) {
            if (axis == 0 && side == 0 && replaces_left_wall(boundaries)) continue;
            const WallRule rule = boundaries.walls[axis][side];
            if (rule == WallRule::slip) mirrors[axis][side] = Mirror::slip;
            if (rule == WallRule::stick) mirrors[axis][side] = Mirror::stick;
        }
    }
    return mirrors;
}

template <int D, class Real>
WallAction<D> apply_boundaries(const Layout<D>& layout, const Boundaries<D>& boundaries, double time,
                               const Index<D>& block, Node<Real>* nodes) {
    WallAction<D> action;
    const Limits<D> limits(layout, boundaries, time);
    if (!reaches_block(layout, limits, block)) return action;
    action.impulse = change_nodes<D, Real>(layout, block, nodes, [&](const Index<D>& at, Node<Real>& node) {
        apply_walls(layout, limits, at, node);
        apply_shelf(limits, at, node);
        if (at[0] > limits.pushed) return;
        const auto velocity = std::max(node[0], static_cast<Real>(limits.push_velocity));
        const auto gain = static_cast<double>(velocity - node[0]);
        action.work += static_cast<double>(node[mass_lane]) * gain * limits.push_velocity;
        node[0] = velocity;
    });
    return action;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                               \
    template WallAction<D> apply_boundaries<D, Real>(const Layout<D>&, const Boundaries<D>&, double, \
                                                     const Index<D>&, Node<Real>*);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)
template Mirrors<2> mirrors_of(const Boundaries<2>&);
template Mirrors<3> mirrors_of(const Boundaries<3>&);

}  // namespace tidewater::mpm
