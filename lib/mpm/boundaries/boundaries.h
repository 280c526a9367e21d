// The table of boundaries: everything that holds, moves or damps nodes or takes water, once each.
//
// A new one is a header of its own, a member of Boundaries and a word in boundary_table. Its struct says
//
//     acting(layout, step)               what it does during one step, computed once: an object with
//         on(block)                          what it does in a block of nodes; false where it does nothing;
//             act(node, velocity, action)        to one node, with the work that this takes
//         account(action)                    optional: of a block's impulse
//     replaces_left_wall()               whether it moves in from x = 0 instead of the wall
//     hides_fill(layout)                 whether any node's share of water may be unknown because of it,
//     hides_fill_at(layout, time, node)      and whether that of this node is (mpm/step/crowding.h)
//
// Calls are by type, none is virtual. What takes particles rather than acting on nodes does so when particles
// are sorted (mpm/step/drain.h).
#pragma once

#include <tuple>
#include <utility>

#include "mpm/base/interval.h"
#include "mpm/boundaries/bed.h"
#include "mpm/boundaries/outlet.h"
#include "mpm/boundaries/piston.h"
#include "mpm/boundaries/push.h"
#include "mpm/boundaries/shelf.h"
#include "mpm/boundaries/sponge.h"
#include "mpm/boundaries/walls.h"

namespace tidewater::mpm {

template <int D>
struct Boundaries {
    Walls<D> walls{};
    Shelf shelf;
    Push push;
    Bed<D> bed;
    Piston piston;
    Sponge sponge;
    Outlet outlet;
};

// In the order in which they act on a node. The bed comes first: after the bottom wall it would turn what
// presses on a slope into motion along it.
template <int D>
inline constexpr std::tuple boundary_table{
    &Boundaries<D>::bed,    &Boundaries<D>::walls,  &Boundaries<D>::shelf, &Boundaries<D>::push,
    &Boundaries<D>::piston, &Boundaries<D>::outlet, &Boundaries<D>::sponge};

// Calls visit(boundary) for each, in that order.
template <int D, class Visit>
void for_each_boundary(const Boundaries<D>& boundaries, const Visit& visit) {
    std::apply([&](const auto... member) { (visit(boundaries.*member), ...); }, boundary_table<D>);
}

template <int D>
bool replaces_left_wall(const Boundaries<D>& boundaries) {
    bool replaced = false;
    for_each_boundary(boundaries, [&](const auto& of) { replaced = replaced || of.replaces_left_wall(); });
    return replaced;
}

// The walls that mirror: those that slip or stick and are not replaced by something that moves.
template <int D>
Mirrors<D> mirrors_of(const Boundaries<D>& boundaries);

// What boundaries are told of the step that follows `interval`, whose forces the nodes are getting. `damping`
// is the time over which a sponge damps, s.
template <int D>
BoundaryStep boundary_step(const Boundaries<D>& boundaries, const Interval& interval, double damping) {
    BoundaryStep step;
    if (!interval.settling) step.time = interval.end();
    step.dt = damping;
    step.left_wall_moves = replaces_left_wall(boundaries);
    return step;
}

// What all of them do during one step, in the table's order. Refers to its arguments.
template <int D>
auto acting_boundaries(const Layout<D>& layout, const Boundaries<D>& boundaries, const BoundaryStep& step) {
    return std::apply(
        [&](const auto... member) { return std::tuple((boundaries.*member).acting(layout, step)...); },
        boundary_table<D>);
}
template <int D>
using ActingBoundaries =
    decltype(acting_boundaries<D>(std::declval<const Layout<D>&>(), std::declval<const Boundaries<D>&>(),
                                  std::declval<const BoundaryStep&>()));

// Applies them to the velocities of one block of nodes; `block` as block_at gives it.
template <int D, class Real>
WallAction<D> apply_boundaries(const Layout<D>& layout, const ActingBoundaries<D>& acting,
                               const Index<D>& block, Node<Real>* nodes);

}  // namespace tidewater::mpm
