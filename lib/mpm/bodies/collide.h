// Where rigid bodies touch walls, the bed and each other, and what stops them there.
//
// A contact is a point with a unit normal n towards body a and the gap δ that is left. The bodies' motions
// u = (V, ω) keep
//
//     n·(v_a − v_b) ≥ −max(δ, 0)/Δt      at each contact, v the velocity there; a wall's is 0
//     u = u₀ + A⁻¹ Σ (n, r × n) λ,       λ ≥ 0 kg m/s and λ = 0 where the contact parts
//
// so a body stops at what it meets (no rebound, no friction) and does not run into it first. A is the matrix
// of the body's mass and inertia together with those of the water that must move with it
// (mpm/step/contact.h): a wall then holds the water behind a body too. Gauss–Seidel over the contacts, in
// their order.
//
// Walls are met by corners, the bed and other bodies by points on the surface one cell apart; between two
// bodies the points of each against the faces of the other. What went too deep by the curvature of a turn is
// pushed back by max_correction at most in a step; that moves bodies but not their velocities, so it is
// the one thing that changes angular momentum, by the way times the momentum. Test:
// tests/unit/mpm/bodies/collide_test.cpp.
#pragma once

#include "mpm/bodies/rigid.h"
#include "mpm/boundaries/boundaries.h"

namespace tidewater::mpm {

using Vector6 = Eigen::Matrix<double, 6, 1>;  // (V, ω), or momentum and angular momentum
using Matrix6 = Eigen::Matrix<double, 6, 6>;

inline constexpr double max_correction = 0.05;  // cells

struct ContactPoint {
    int a = 0, b = -1;                                       // bodies; b −1: a wall or the bed
    Vector6 on_a = Vector6::Zero(), on_b = Vector6::Zero();  // (n, r × n) with r from each centre
    double gap = 0.0;                                        // δ, m
    double impulse = 0.0;                                    // λ, kg m/s
};

// All contact points that bodies moving at their present speeds might make within a step of dt, in an order
// that does not depend on threads. First pushes back what is too deep.
template <int D>
std::vector<ContactPoint> find_contacts(const Layout<D>& layout, const Boundaries<D>& boundaries, double dt,
                                        std::vector<RigidBody>& bodies);

// Finds the impulses and adds what they change to the motions.
//     inverse   A⁻¹ of each body
//     motion    u₀ of each body; becomes u
void solve_contacts(double dt, const std::vector<Matrix6>& inverse, std::vector<ContactPoint>& contacts,
                    std::vector<Vector6>& motion);

}  // namespace tidewater::mpm
