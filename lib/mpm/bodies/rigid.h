// A rigid body: a box with exact position, motion and shape (lib/mpm/README.md, Bodies).
//
//     c ← c + Δt V,   R ← exp(Δt [ω]×) R,   L kept, ω ← I⁻¹ L with the turned I
//     I = R diag(I₁, I₂, I₃) Rᵀ,   I₁ = (h₂² + h₃²) M/3 …,   with half edges h and mass M
//
// The body is not a cloud of particles. Its contact with the grid's nodes is in mpm/step/contact.h, that with
// walls and other bodies in mpm/bodies/collide.h. A 2D scene is treated as the x–z plane of 3D, with h₂ = 0.
// Positions are relative to a node near the body's start, so that a scene moved by whole blocks gives the
// same bits.
//
// The body's share of a node is the part of the node's room that it takes,
//
//     s(r) = ∫ over the box of N(x − r)/Δx^D dx ≈ Π_k [Φ((h_k − r_k)/Δx) − Φ((−h_k − r_k)/Δx)],
//
// with r in the body's axes, N the quadratic B-spline and Φ its integral from −∞. The product is exact where
// the body's axes are those of the grid. For a turned body the spline is turned with it, which changes the
// sum of the shares by at most 0.2 %. −∇s is the outward normal, smooth around the edges.
//
// Test: tests/unit/mpm/bodies/rigid_test.cpp.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "mpm/grid/grid.h"

namespace tidewater::mpm {

// The contact of water with a body.
//     stick  water moves with the body's surface
//     slip   water slides along the surface and may part from it
enum class BodyContact { stick, slip };

// A body at the start of a simulation. Lengths are in m; in 2D vectors are (x, z) and mass is per metre of
// width.
template <int D>
struct RigidStart {
    Vector<D, double> size = Vector<D, double>::Zero();    // edges along the body's own axes, > 0
    Vector<D, double> center = Vector<D, double>::Zero();  // in the box
    double angle = 0.0;                                    // rad, in the x–z plane from x towards z
    double density = 920.0;                                // kg/m³
    BodyContact contact = BodyContact::slip;
    double friction = 0.0;  // Coulomb's coefficient, ≥ 0; read for slip only
    double drag = 0.0;      // C_d of water along its faces, ≥ 0; read for slip only (mpm/step/contact.h)
    Vector<D, double> velocity = Vector<D, double>::Zero();  // of the centre, m/s
    double spin = 0.0;                                       // rad/s, in the sense of `angle`
};

struct RigidBody {
    std::array<int, 3> anchor{};                       // a node near the start, (x, y, z) with y = 0 in 2D
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  // c from the anchor, m; y = 0 in 2D
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // V, m/s
    Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  // L about c, kg m²/s
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // ω, rad/s

    // Impulse (kg m/s) and angular impulse (kg m²/s) since the start: from water and ice, and from contacts
    // with walls, the bed and other bodies.
    Eigen::Vector3d water_impulse = Eigen::Vector3d::Zero(), water_angular_impulse = Eigen::Vector3d::Zero();
    Eigen::Vector3d contact_impulse = Eigen::Vector3d::Zero();

    // The rest never changes.
    Eigen::Vector3d half_size = Eigen::Vector3d::Zero();  // h, m
    Eigen::Vector3d inertia = Eigen::Vector3d::Zero();    // I₁ … I₃, kg m²
    double mass = 0.0;                                    // M, kg
    BodyContact contact = BodyContact::slip;
    double friction = 0.0, drag = 0.0;
    std::vector<Eigen::Vector3d> surface;  // m, in its own axes: corners, then points ≤ Δx apart

    Eigen::Vector3d center_in_box(double cell_size) const {  // m, from the scene's origin
        return center + cell_size * Eigen::Vector3d(anchor[0], anchor[1], anchor[2]);
    }
    Eigen::Vector3d velocity_at(const Eigen::Vector3d& arm) const {  // m/s; arm from the centre, m
        return velocity + angular_velocity.cross(arm);
    }
    double radius() const { return half_size.norm(); }  // m, from the centre to a corner
};

// The anchor as a node index of D axes.
template <int D>
Index<D> anchor_of(const RigidBody& body) {
    if constexpr (D == 2)
        return {body.anchor[0], body.anchor[2]};
    else
        return {body.anchor[0], body.anchor[1], body.anchor[2]};
}

template <int D>
RigidBody make_rigid_body(const RigidStart<D>& start, double cell_size);

// Advances c, R and ω by dt (s).
void move_rigid_body(double dt, RigidBody& body);

// I in the axes of the scene, kg m².
Eigen::Matrix3d world_inertia(const RigidBody& body);

// ½ M V² + ½ ω·L, J.
double kinetic_energy(const RigidBody& body);

// The maximum speed of the body, which is that of a corner, m/s.
double max_speed(const RigidBody& body);

struct NodeShare {
    double value = 0.0;                               // s, from 0 to 1
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();  // ∇s, 1/m
};

// The share of a node at `arm` (m) from the centre, without the body's images.
template <int D>
NodeShare share_of(const RigidBody& body, double cell_size, const Eigen::Vector3d& arm);

// The share of a node, with the shares of the body's images beyond mirrors (mpm/grid/mirror.h) added. A node
// on a mirror and within the body thus has the share 1, though only half of its room is in the tank.
template <int D>
NodeShare share_of_node(const Layout<D>& layout, const RigidBody& body, const Index<D>& node);

// A box of nodes.
template <int D>
struct NodeRange {
    Index<D> first{}, last{};  // both included
};

// A box that contains all nodes of which the body or its images have a share; beyond a mirror it ends after
// three layers of nodes.
template <int D>
NodeRange<D> reach_of(const Layout<D>& layout, const RigidBody& body);

// Points (m) on a lattice within the body, parallel to its own axes and of about this spacing (m), always in
// the same order. They stand for the body in files and pictures.
template <int D>
std::vector<Vector<D, double>> points_within(const RigidBody& body, double cell_size, double spacing);

}  // namespace tidewater::mpm
