// The table of boundaries: everything that holds, moves or damps nodes, or drains water, is listed here once.
//
// A new boundary is a header of its own, a member of Boundaries and an entry of boundary_table. It has
//
//     acting(layout, step)               what it does during one step, computed once: an object with
//         on(block)                          what it does in one block of nodes, as a pointer or optional
//                                            that is empty where it does nothing: an object with
//             act(at, velocity, action)          changes one node and adds the work that this takes
//             narrow(block, box)                   leaves of a box of nodes in the block what it may change;
//                                                optional, and only to save time
//
// and, where there is anything to say,
//
//         account(action)                    sets the work from the impulse given to a whole block
//         tells_matter(block)                whether it treats this block's ice and water differently
//     tells_matter()                     whether it does so anywhere
//     replaces_left_wall()               whether it moves in from x = 0 in place of the wall
//     hides_fill(layout)                 whether it leaves the fill of any node unknown (mpm/step/crowding.h)
//     hides_fill_at(layout, time, node)  whether it leaves the fill of this node unknown
//
// Calls are resolved by type; none is virtual. What drains water, outlet and sponge, acts on
// particles when these are sorted (mpm/step/drain.h, mpm/step/skim.h).
//
// A node knows what it is made of (NodeAt::matter). Ice and water share one velocity per node so far, and a
// boundary acts on the one of which there is more; with a velocity for each it would be called once for
// each of them, as it is.
//
// Tests: tests/unit/mpm/boundaries/boundaries_test.cpp, tests/unit/mpm/flume_test.cpp.
#pragma once

#include <tuple>
#include <utility>

#include "mpm/base/interval.h"
#include "mpm/boundaries/bed.h"
#include "mpm/boundaries/drag.h"
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
    Drag drag;
    Piston piston;
    Sponge sponge;
    Outlet outlet;
};

// The boundaries in the order in which they act on a node. The bed comes before the walls: after the bottom
// wall it would turn velocity that presses on a slope into motion along the slope. Drag was found from
// velocities that nothing holds yet.
template <int D>
inline constexpr std::tuple boundary_table{
    &Boundaries<D>::drag, &Boundaries<D>::bed,    &Boundaries<D>::walls,  &Boundaries<D>::shelf,
    &Boundaries<D>::push, &Boundaries<D>::piston, &Boundaries<D>::outlet, &Boundaries<D>::sponge};

// Calls visit(boundary) for each boundary, in the order of the table.
template <int D, class Visit>
void for_each_boundary(const Boundaries<D>& boundaries, const Visit& visit) {
    std::apply([&](const auto... member) { (visit(boundaries.*member), ...); }, boundary_table<D>);
}

template <int D>
bool replaces_left_wall(const Boundaries<D>& boundaries) {
    bool replaced = false;
    for_each_boundary(boundaries, [&](const auto& boundary) {
        if constexpr (requires { boundary.replaces_left_wall(); })
            replaced = replaced || boundary.replaces_left_wall();
    });
    return replaced;
}

// Whether ice is slowed by friction on any ground.
template <int D>
bool rubs(const Boundaries<D>& boundaries) {
    return (boundaries.bed.exists() && boundaries.bed.rule.ice.resists()) ||
           (boundaries.shelf.exists() && boundaries.shelf.rule.ice.resists());
}

// The mirrors of the box: every wall that slips or sticks mirrors, unless a boundary that moves replaces it.
template <int D>
Mirrors<D> mirrors_of(const Boundaries<D>& boundaries);

// The step that follows `interval`, as boundaries need to know it: the nodes have just got their forces. `dt`
// (s) is the time over which what works by rates acts: sponge, pressure, sliding.
template <int D>
BoundaryStep boundary_step(const Boundaries<D>& boundaries, const Interval& interval, double dt) {
    BoundaryStep step;
    if (!interval.settling) step.time = interval.end();
    step.dt = dt;
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

// Whether any boundary treats ice and water differently.
template <int D>
bool tells_matter(const Boundaries<D>& boundaries) {
    bool tells = false;
    for_each_boundary(boundaries, [&](const auto& boundary) {
        if constexpr (requires { boundary.tells_matter(); }) tells = tells || boundary.tells_matter();
    });
    return tells;
}

// Whether any boundary does so in this block.
template <int D>
bool tells_matter(const ActingBoundaries<D>& acting, const Index<D>& block);

// Applies the boundaries to the velocities of one block of nodes, and returns their impulse and work.
//     block   as block_at gives it
//     matter  what the nodes are made of
//     grip    the grip of each node (NodeAt), or null
//     nodes   the Block<D>::nodes nodes of the block
//     box     holds those of them that have mass
template <int D, class Real>
WallAction<D> apply_boundaries(const Layout<D>& layout, const ActingBoundaries<D>& acting,
                               const Index<D>& block, const BlockMatter<Real>& matter, float* grip,
                               Node<Real>* nodes, const NodeBox<D>& box = NodeBox<D>::all());

}  // namespace tidewater::mpm
