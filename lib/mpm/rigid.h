// A rigid body: its particles move as one (shared/physics.md §5).
//
// After the grid's update the body takes over the momentum that its particles read from the grid, and goes
// on with the one rigid motion that has the same linear and angular momentum:
//
//     P = Σ m v_p,                V = P / M
//     L = Σ m [ (x_p − c) × v_p + (Δx²/4) ε:C_pᵀ ],   ω = I⁻¹ L
//     I = Σ m [ (|r|² 1 − r rᵀ) + (Δx²/2) 1 ],        r = x_p − c
//     c ← c + Δt V,   R ← exp(Δt [ω]×) R,   L kept, ω ← I⁻¹ L with the turned I
//     x_p = c + R r0_p,   v_p = V + ω × (x_p − c),   C_p = [ω]×
//
// The Δx² terms are the angular momentum that APIC keeps in C; with them the exchange with the water
// conserves both momenta to rounding. They make the body harder to turn by Δx²/2 per mass: at 12 cells
// across, 2 % of its inertia. 2D is treated as the x–z plane of 3D. Positions are relative to a node near the
// body's start, so that a scene moved by whole blocks gives the same bits. Test:
// tests/unit/mpm/rigid_test.cpp.
#pragma once

#include <Eigen/Geometry>

#include "mpm/particles.h"

namespace tidewater::mpm {

// How water meets a body: it moves with its surface, or slides along it and may part from it.
enum class BodyContact { stick, slip };

struct RigidBody {
    std::array<int, 3> anchor{};                       // node, (x, y, z) with y = 0 in 2D
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  // c from the anchor, m; y = 0 in 2D
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // V, m/s
    Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  // L about c, kg m²/s
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // ω, rad/s
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();           // I in the body's own axes, kg m²
    double mass = 0.0;                                           // M, kg
    double radius = 0.0;                                         // of the farthest particle from c, m

    Eigen::Vector3d center_in_box(double cell_size) const {  // m from the box's corner
        return center + cell_size * Eigen::Vector3d(anchor[0], anchor[1], anchor[2]);
    }
    double swing =
        1.0;  // √(1 + R²/k²) with M k² the least moment of inertia about an axis that it can turn about

    // No particle is faster, not even after the body touches a wall, which may turn all of its energy into
    // rotation but never adds any: |V + ω × r| ≤ swing √(2 E/M), m/s.
    double speed_bound() const;
};

// The anchor as an index of D axes.
template <int D>
Index<D> anchor_of(const RigidBody& body) {
    if constexpr (D == 2)
        return {body.anchor[0], body.anchor[2]};
    else
        return {body.anchor[0], body.anchor[1], body.anchor[2]};
}

// The body of these particles, at rest; fills their offset column (r0). `points` are their positions, m, in
// order.
template <int D, class Real>
RigidBody make_rigid_body(const std::vector<Vector<D, double>>& points, double cell_size,
                          Particles<D, Real>& particles);

// By how many cells a wall pushes a body back in one step at most, so that no particle leaves its tile.
inline constexpr double greatest_correction = 0.05;

struct WallContact {
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  // that the walls gave to the body, kg m/s
    double correction =
        0.0;  // by which they pushed it back along any axis: its particles follow when it moves next, m
};

// Gives the body the momentum that its particles read from the grid and stops it at the walls.
template <int D, class Real>
WallContact take_over_momentum(const Grid<D, Real>& grid, const Particles<D, Real>& particles,
                               RigidBody& body);

// c and R advance by dt.
void move_rigid_body(double dt, RigidBody& body);

// Scatters the body's particles in particle block `slot` as they are at its present place and motion; writes
// their positions.
template <int D, class Real>
void scatter_rigid(const Layout<D>& layout, const RigidBody& body, const Index<D>& block, std::size_t slot,
                   Particles<D, Real>& particles, Node<Real>* tile);

// ½ M V² + ½ ω·L, J.
double kinetic_energy(const RigidBody& body);

}  // namespace tidewater::mpm
