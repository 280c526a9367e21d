// Rigid bodies in the grid: the nodes that a body has a share of meet its surface.
//
// A node i with mass m_i, of which the body's share (mpm/bodies/rigid.h) is above min_share, takes part:
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
// and other bodies (mpm/bodies/collide.h) are part of it. Implicit in the added mass: light bodies and large
// steps stay stable. A node that two bodies share meets the one with the larger share.
//
// Only nodes of blocks near a body are looked at. Water's volume knows where the body's surface is by its
// share (mpm/step/crowding.h), not by which nodes take part.
//
// min_share is that of a node wall_reach cells outside of a flat face (mpm/boundaries/wall.h says why not 0).
// Source: the family of Bardenhagen et al. (2000) contacts, with an implicit rigid partner. Test:
// tests/unit/mpm/step/contact_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// (1.5 − wall_reach)³/6
inline constexpr double min_share = (1.5 - wall_reach) * (1.5 - wall_reach) * (1.5 - wall_reach) / 6.0;

// What the contacts need to know of a step.
struct ContactStep {
    double dt = 0.0;       // s, of the forces that the nodes' velocities have
    double falling = 0.0;  // s, of their weight that bodies have not been given yet
    double gravity = 0.0;  // m/s²
    bool held = false;     // the scene settles: bodies stay, and water slips along all of them
};

// Gives the bodies their weight's impulse, and bodies and nodes each other's. Impulses of walls on bodies,
// and of what holds bodies while the scene settles, go to wall_impulse, kg m/s.
template <int D, class Real>
void resolve_contacts(const ContactStep& step, const Boundaries<D>& boundaries, Grid<D, Real>& grid,
                      std::vector<RigidBody>& bodies, Vector<D, double>& wall_impulse);

}  // namespace tidewater::mpm
