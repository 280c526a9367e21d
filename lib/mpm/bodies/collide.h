// Contacts of rigid bodies with walls, the bed and each other, and the impulses that stop the bodies there.
//
// A contact is a point with a unit normal n towards body a and a gap δ. The bodies' motions u = (V, ω) keep
//
//     n·(v_a − v_b) ≥ −max(δ, 0)/Δt      at each contact, with v the velocity there; a wall's is 0
//     u = u₀ + A⁻¹ Σ (n, r × n) λ,       with impulses λ ≥ 0 (kg m/s), and λ = 0 where the contact parts
//
// so that a body stops at an obstacle without rebound or friction and does not penetrate it first. A is the
// matrix of the body's mass and inertia and of the water that must move with the body (mpm/step/contact.h),
// so that a wall also holds the water behind a body. The impulses are found by Gauss–Seidel over the
// contacts, in their order.
//
// Contacts with walls are at the body's corners; those with the bed and with other bodies are at points of
// its surface one cell apart. Between two bodies, the points of each are checked against the faces of the
// other. A turning body's curved path can still take it too deep; it is then pushed back by max_correction at
// most in a step. That moves bodies without changing their velocities, and is the only thing that changes
// angular momentum: by the displacement times the momentum.
//
// Test: tests/unit/mpm/bodies/collide_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mpm/bodies/rigid.h"
#include "mpm/boundaries/boundaries.h"

namespace tidewater::mpm {

using Vector6 = Eigen::Matrix<double, 6, 1>;  // (V, ω), or momentum and angular momentum
using Matrix6 = Eigen::Matrix<double, 6, 6>;

inline constexpr double max_correction = 0.05;  // cells per step

struct ContactPoint {
    std::size_t a = 0;                                       // the body that the normal points to
    std::optional<std::size_t> b;                            // the other body; empty: a wall or the bed
    Vector6 on_a = Vector6::Zero(), on_b = Vector6::Zero();  // (n, r × n) with r from each centre
    double gap = 0.0;                                        // δ, m
    double impulse = 0.0;                                    // λ, kg m/s
};

// Returns all contacts that the bodies might make within a step of dt (s), in an order that does not depend
// on threads. Pushes back bodies that are too deep; their velocities stay.
template <int D>
std::vector<ContactPoint> find_contacts(const Layout<D>& layout, const Boundaries<D>& boundaries, double dt,
                                        std::vector<RigidBody>& bodies);

// Finds the impulses λ of the contacts and the motions that result from them.
//     dt        s, in which the gaps may close
//     inverse   [body] A⁻¹
//     contacts  impulses must be 0; become λ
//     motion    [body] u₀; becomes u
void solve_contacts(double dt, const std::vector<Matrix6>& inverse, std::vector<ContactPoint>& contacts,
                    std::vector<Vector6>& motion);

}  // namespace tidewater::mpm
