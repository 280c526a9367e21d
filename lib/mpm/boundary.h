// What holds or moves the nodes at the edges of a scene: the walls of its box, a shelf in it, a plane that
// pushes from the left; and what has its own files, a bed, a piston and a sponge.
//
// A rule (mpm/wall.h) acts on the grid nodes on the wall's plane and beyond it. Just beyond a wall of the box
// that slips or sticks, velocities mirror those inside (mpm/mirror.h), so that particles near it move towards
// the plane ever slower and do not pass it; beyond `separate` walls, shelf and push one can come half a cell.
// Source: lib/mpm/README.md, Boundaries. Test: tests/unit/mpm/boundary_test.cpp.
#pragma once

#include <array>

#include "mpm/bed.h"
#include "mpm/piston.h"
#include "mpm/sponge.h"
#include "mpm/wall.h"

namespace tidewater::mpm {

// [axis][0: at the origin, 1: at the far end]
template <int D>
using Walls = std::array<std::array<WallRule, 2>, static_cast<std::size_t>(D)>;

// Ground without friction that fills the box from the left wall to x = end and from the bottom to z = top (in
// 3D for all y). Its top follows `rule`; its front face always lets go. Edges lie on cell edges. A shelf that
// retreats draws its front back under what lies on it, cell by cell, and leaves water or nothing behind.
struct Shelf {
    double end = 0.0, top = 0.0;  // m, at time 0; end 0: no shelf
    WallRule rule = WallRule::separate;
    double retreat = 0.0;  // m/s, of the end from time 0 on, towards the left wall

    bool exists() const { return end > 0.0; }
    double end_at(double time) const;  // m
};

// A plane that starts from the left wall at t = 0 and pushes: nodes behind it and the next before it move
// along x at least as fast as it does; it holds nothing back. It takes the place of the left wall. Its speed
// rises as speed (1 − cos(πt/ramp))/2.
struct Push {
    double speed = 0.0;  // m/s; 0: no plane
    double ramp = 0.0;   // s

    bool exists() const { return speed != 0.0; }
    double velocity(double time) const;  // m/s; 0 before time 0
    double position(double time) const;  // m
};

template <int D>
struct Boundaries {
    Walls<D> walls{};
    Shelf shelf;
    Push push;
    Bed<D> bed;
    Piston piston;  // takes the place of the left wall
    Sponge sponge;
};

// The walls that mirror: those that slip or stick and are not replaced by a plane that pushes or a piston.
template <int D>
Mirrors<D> mirrors_of(const Boundaries<D>& boundaries);

// Applies them to the velocities that one block of nodes has at `time`; `block` as block_at gives it.
template <int D, class Real>
WallAction<D> apply_boundaries(const Layout<D>& layout, const Boundaries<D>& boundaries, double time,
                               const Index<D>& block, Node<Real>* nodes);

}  // namespace tidewater::mpm
