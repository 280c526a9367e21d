// Rigid bodies in the grid: the nodes that a body has a share of meet its surface.
//
// A node i with mass m_i, of which the body's share (mpm/bodies/rigid.h) is above least_share, takes part:
//
//     stick    v_i' = U(x_i),   U(x) = V + ω × (x − c)
//     slip     v_i' = v_i + n n·(U(x_i) − v_i)   where that presses on the water, else v_i' = v_i,
//              with n = −∇s/|∇s|; then friction changes what slips along n by at most μ times the change
//              along n. (Deep inside, where ∇s says nothing, a node sticks.)
//
// The body's motion u = (V, ω) and these velocities are found together, so that what the nodes gain the body
// loses, linear and angular momentum alike:
//
//     [diag(M, I) + Σ m_i J_iᵀ P_i J_i] u = (M V*, L*) + Σ m_i J_iᵀ P_i v_i + walls,      P = 1 or n nᵀ
//
// with J u = V + ω × r, V* after gravity. Which slipping nodes press is found by turns; the impulses of walls
// and other bodies (mpm/bodies/collide.h) are part of it. Implicit in the added mass: light bodies and large steps
// stay stable. A node that two bodies share meets the one with the larger share.
//
// Only nodes of blocks near a body are looked at. Water's volume knows where the body's surface is by its
// share (mpm/step/crowding.h), not by which nodes take part.
//
// least_share is that of a node wall_reach cells outside of a flat face (mpm/boundaries/wall.h says why not 0). Source:
// the family of Bardenhagen et al. (2000) contacts, with an implicit rigid partner. Test:
// tests/unit/mpm/step/contact_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// (1.5 − wall_reach)³/6
inline constexpr double least_share = (1.5 - wall_reach) * (1.5 - wall_reach) * (1.5 - wall_reach) / 6.0;

// The nodes hold velocities with the forces of a step of dt. Gives the bodies their weight's impulse of the
// time `falling` and both each other's. While the simulation settles the bodies are held, and water slips
// along them all to find its place.
template <int D, class Real>
void meet_bodies(double dt, double falling, Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
