// Walls of the box that a scene lives in.
//
//     slip      the velocity into or out of the wall is zero, along it free
//     stick     the velocity is zero
//     separate  as slip, but what moves away from the wall may leave it
//
// A rule acts on the grid nodes on the wall's plane and beyond it, so that a particle can come no closer than
// half a cell beyond the plane. Source: shared/physics.md §5. Test: tests/unit/mpm/boundary_test.cpp.
#pragma once

#include <array>

#include "mpm/grid.h"

namespace tidewater::mpm {

enum class WallRule { slip, stick, separate };

// [axis][0: at the origin, 1: at the far end]
template <int D>
using Walls = std::array<std::array<WallRule, 2>, static_cast<std::size_t>(D)>;

// What walls did to the nodes of one block.
template <int D>
struct WallAction {
    Vector<D, double> impulse = Vector<D, double>::Zero();  // kg m/s given to the nodes
};

// Applies the walls to the velocities of one block of nodes; `block` as block_at gives it.
template <int D, class Real>
WallAction<D> apply_walls(const Layout<D>& layout, const Walls<D>& walls, const Index<D>& block,
                          Node<Real>* nodes);

}  // namespace tidewater::mpm
