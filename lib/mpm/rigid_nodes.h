// A rigid body on the grid: its nodes move as the body does, the water's share of them too.
//
//     U(x) = V + ω × (x − c),   with V, c and ω the rigid motion that has the linear and angular momentum of
//     these nodes
//
// Water then feels a wall that moves with the body. (Without this, pressure would push the nodes at the
// body's surface by Δt p/(ρ Δx) per step relative to the body, and water would leak in at that speed: 0.07
// m/s at Δx = 4 cm, c0 = 31 m/s and half a metre of depth.)
//
// A node is the body's if the body fills at least least_share of it, which along a flat face is so up to one
// cell outside. The last such node is then half a cell outside on average, and water comes to half a cell
// from it: the body is as large for the water as it is. (With every touched node, up to one cell and a half
// outside, a block of 10 cells floated half a cell too high.) Test: tests/unit/mpm/rigid_test.cpp.
#pragma once

#include "mpm/rigid.h"

namespace tidewater::mpm {

// ∫ N(x) dx from one cell to the end of the quadratic B-spline N.
inline constexpr double least_share = 1.0 / 48.0;

// The grid's nodes hold velocities and masses.
template <int D, class Real>
void move_nodes_as_one(const Particles<D, Real>& particles, const RigidBody& body, Grid<D, Real>& grid);

}  // namespace tidewater::mpm
