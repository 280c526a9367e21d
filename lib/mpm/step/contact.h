// Contact of rigid bodies with the grid: the nodes of which a body has a share follow its surface.
//
// A node i with mass m_i, of which the body's share (mpm/bodies/rigid.h) is above min_share, takes part:
//
//     stick    v_i' = U(x_i),   U(x) = V + ω × (x − c)
//     slip     v_i' = v_i + n n·(U(x_i) − v_i)   where that presses on the water, else v_i' = v_i,
//              with n = −∇s/|∇s|. Friction then changes the velocity along the surface by at most μ times the
//              change along n, and drag slows what is left, u, by u K/(1 + K), K = ρw C_d A u Δt/m_i.
//              Deep inside, where ∇s gives no direction, a node sticks.
//
// A = |∇s| Δx^D/0.93 is the part of the face that a node stands for: over all nodes that have a share
// |∇s| Δx^D sums to the face's area, over those that take part to 0.93 of it on average. Drag acts on the
// nodes at the face alone (not on a whole column of water, mpm/boundaries/drag.h): it tells the force on a
// body, while the water that it drags along stays within cells of the face.
//
// The body's motion u = (V, ω) and these velocities are found together, so that the body loses the impulse
// and the angular impulse that the nodes gain:
//
//     [diag(M, I) + Σ m_i J_iᵀ P_i J_i] u = (M V*, L*) + Σ m_i J_iᵀ P_i v_i + walls,      P = 1 or n nᵀ
//
// with J u = V + ω × r and V* the velocity after gravity. Iteration finds which of the slipping nodes press.
// The impulses of walls and other bodies (mpm/bodies/collide.h) are part of the solution. The scheme is
// implicit in the added mass, so that light bodies and large steps stay stable. Of two bodies that share a
// node, the one with the larger share is in contact with it.
//
// Only nodes of blocks near a body are visited. The volume of water depends on the bodies' shares
// (mpm/step/crowding.h), not on which nodes take part here.
//
// Source: the family of Bardenhagen et al. (2000) contacts, with an implicit rigid partner.
// Tests: tests/unit/mpm/step/contact_test.cpp, tests/unit/mpm/bodies/collide_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The share (1.5 − wall_reach)³/6 of a node that lies wall_reach cells outside of a flat face: bodies hold
// nodes as far in front of them as other surfaces do, and for the same reason (mpm/boundaries/wall.h).
inline constexpr double min_share = (1.5 - wall_reach) * (1.5 - wall_reach) * (1.5 - wall_reach) / 6.0;

// What contacts need to know of a step.
struct ContactStep {
    double dt = 0.0;             // s, the step that these velocities move things by
    double force_dt = 0.0;       // s, for which gravity on bodies and drag have still to act
    double gravity = 0.0;        // m/s²
    double water_density = 0.0;  // kg/m³, ρw of the drag
    bool held = false;           // the scene settles: bodies stay in place, and water slips along all of them
};

// Gives the bodies gravity's impulse and resolves their contacts with nodes, walls, the bed and each other.
//     grid          reads the masses and velocities of nodes; writes the velocities of those in contact
//     bodies        reads their motions; writes these and their impulses, and pushes back what is too deep
//     accounts      adds to wall_impulse those of walls and bed on bodies, and of what holds bodies while the
//                   scene settles, and to friction_work and drag_work those along the bodies' faces
template <int D, class Real>
void resolve_contacts(const ContactStep& step, const Boundaries<D>& boundaries, Grid<D, Real>& grid,
                      std::vector<RigidBody>& bodies, Accounts<D>& accounts);

}  // namespace tidewater::mpm
