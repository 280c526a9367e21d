// A rigid body: its particles move as one (shared/physics.md §5).
//
// After the particles gathered their velocities from the grid, the body takes over their momentum and goes on
// with the one rigid motion that has the same linear and angular momentum:
//
//     P = Σ m v_p,                V = P / M
//     L = Σ m [ (x_p − c) × v_p + (Δx²/4) ε:C_pᵀ ],   ω = I⁻¹ L
//     I = Σ m [ (|r|² 1 − r rᵀ) + (Δx²/2) 1 ],        r = x_p − c
//     c ← c + Δt V,   R ← exp(Δt [ω]×) R,   L kept, ω ← I⁻¹ L with the turned I
//     x_p = c + R r0_p,   v_p = V + ω × (x_p − c),   C_p = [ω]×
//
// The Δx² terms are the angular momentum that APIC keeps in C; with them the exchange with the water
// conserves both momenta to rounding. They make the body harder to turn by Δx²/2 per mass: at 12 cells
// across, 2 % of its inertia. 2D is treated as the x–z plane of 3D. Test: tests/unit/mpm/rigid_test.cpp.
#pragma once

#include <Eigen/Geometry>

#include "mpm/particles.h"

namespace tidewater::mpm {

struct RigidBody {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  // c, m; y = 0 in 2D
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // V, m/s
    Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  // L about c, kg m²/s
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // ω, rad/s
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();           // I in the body's own axes, kg m²
    double mass = 0.0;                                           // M, kg
    double radius = 0.0;                                         // of the farthest particle from c, m
};

// The body of these particles, at rest; fills their offset column (r0). `points` are their positions, m, in
// order.
template <int D, class Real>
RigidBody make_rigid_body(const std::vector<Vector<D, double>>& points, double cell_size,
                          Particles<D, Real>& particles);

struct RigidMotion {
    double greatest_speed = 0.0;                             // of a particle, m/s
    Eigen::Vector3d wall_impulse = Eigen::Vector3d::Zero();  // that the walls gave to the body, kg m/s
};

// Takes over the momentum that the particles gathered, stops the body at the walls, moves it by dt and writes
// the particles' new positions, velocities and gradients.
template <int D, class Real>
RigidMotion move_rigid_body(const Grid<D, Real>& grid, double dt, RigidBody& body,
                            Particles<D, Real>& particles);

// ½ M V² + ½ ω·L, J.
double kinetic_energy(const RigidBody& body);

}  // namespace tidewater::mpm
