// The table of boundaries: everything that holds, moves or damps nodes, or drains water, is listed here once.
//
// A new boundary is a header of its own, a member of Boundaries and an entry of boundary_table. It has
//
//     acting(layout, step)               what it does during one step, computed once: an object with
//         on(block)                          what it does in one block of nodes, as a pointer or optional
//                                            that is empty where it does nothing: an object with
//             act(node, velocity, action)        changes one node and adds the work that this takes
//         account(action)                    optional: sets the work from the impulse given to a whole block
//     replaces_left_wall()               whether it moves in from x = 0 in place of the wall
//     hides_fill(layout)                 whether it leaves the fill of any node unknown (mpm/step/crowding.h)
//     hides_fill_at(layout, time, node)  whether it leaves the fill of this node unknown
//
// Calls are resolved by type; none is virtual. What drains water, outlet and sponge, acts on
// particles when these are sorted (mpm/step/drain.h, mpm/step/skim.h).
//
// Tests: tests/unit/mpm/boundaries/boundaries_test.cpp, tests/unit/mpm/flume_test.cpp.
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

// The boundaries in the order in which they act on a node. The bed comes before the walls: after the bottom
// wall it would turn velocity that presses on a slope into motion along the slope.
template <int D>
inline constexpr std::tuple boundary_table{
    &Boundaries<D>::bed,    &Boundaries<D>::walls,  &Boundaries<D>::shelf, &Boundaries<D>::push,
    &Boundaries<D>::piston, &Boundaries<D>::outlet, &Boundaries<D>::sponge};

// Calls visit(boundary) for each boundary, in the order of the table.
template <int D, class Visit>
void for_each_boundary(const Boundaries<D>& boundaries, const Visit& visit) {
    std::apply([&](const auto... member) { (visit(boundaries.*member), ...); }, boundary_table<D>);
}

template <int D>
bool replaces_left_wall(const Boundaries<D>& boundaries) {
    bool replaced = false;
    for_each_boundary(boundaries,
                      [&](const auto& boundary) { replaced = replaced || boundary.replaces_left_wall(); });
    return replaced;
}

// The mirrors of the box: every wall that slips or sticks mirrors, unless a boundary that moves replaces it.
template <int D>
Mirrors<D> mirrors_of(const Boundaries<D>& boundaries);

// The step that follows `interval`, as boundaries need to know it: the nodes have just got the forces of that
// step. `damping` (s) is the time over which a sponge damps.
template <int D>
BoundaryStep boundary_step(const Boundaries<D>& boundaries, const Interval& interval, double damping) {
    BoundaryStep step;
    if (!interval.settling) step.time = interval.end();
    step.dt = damping;
    step.left_wall_moves = replaces_left_wall(boundaries);
    return step;
}

// What each boundary does during one step, in the order of the table. Keeps references to the arguments.
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

// Applies the boundaries to the velocities of one block of nodes, and returns their impulse and work.
//     block  as block_at gives it
//     nodes  the Block<D>::nodes nodes of the block
template <int D, class Real>
WallAction<D> apply_boundaries(const Layout<D>& layout, const ActingBoundaries<D>& acting,
                               const Index<D>& block, Node<Real>* nodes);

}  // namespace tidewater::mpm
