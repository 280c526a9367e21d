// A rigid body on the grid: every node that its particles touch moves as the body does, the water's share of
// it too.
//
//     U(x) = V + ω × (x − c),   with V, c and ω the rigid motion that has the linear and angular momentum of
//     these nodes
//
// Water then feels a wall that moves with the body. (Without this, pressure would push the nodes at the
// body's surface by Δt p/(ρ Δx) per step relative to the body, and water would leak in at that speed: 0.07
// m/s at Δx = 4 cm, c0 = 31 m/s and half a metre of depth.) The price is a layer of up to a cell and a half
// of water that is carried along. Test: tests/unit/mpm/rigid_test.cpp.
#pragma once

#include "mpm/particles.h"

namespace tidewater::mpm {

// The grid holds velocities and masses; its tiles are overwritten. Moments are taken about `center`, m, which
// should be near the body. Nothing is done for a body without particles.
template <int D, class Real>
void move_nodes_as_one(const Particles<D, Real>& particles, const Eigen::Vector3d& center,
                       Grid<D, Real>& grid);

}  // namespace tidewater::mpm
