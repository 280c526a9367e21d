// A rigid body: a box that moves as one (lib/mpm/README.md, Bodies).
//
//     c ← c + Δt V,   R ← exp(Δt [ω]×) R,   L kept, ω ← I⁻¹ L with the turned I
//     I = R diag(I₁, I₂, I₃) Rᵀ,   I₁ = (h₂² + h₃²) M/3 …,   with half edges h and mass M
//
// It is no cloud of particles: its place, motion and shape are known exactly, and the grid's nodes meet it in
// mpm/step/contact.h, walls and other bodies in mpm/bodies/collide.h. 2D is treated as the x–z plane of 3D,
// with h₂ = 0. Positions are relative to a node near the body's start, so that a scene moved by whole blocks
// gives the same bits.
//
// What the body leaves of a node's room is its share of the node,
//
//     s(r) = ∫ over the box of N(x − r)/Δx^D dx ≈ Π_k [Φ((h_k − r_k)/Δx) − Φ((−h_k − r_k)/Δx)],
//
// r in the body's axes, N the quadratic B-spline and Φ its integral from −∞. Exact where the body's axes are
// those of the grid; where it is turned, the spline is turned with it, which changes the shares' sum by at
// most 0.2 %. −∇s is the outward normal, smooth around the edges. Test: tests/unit/mpm/bodies/rigid_test.cpp.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "mpm/grid/grid.h"

namespace tidewater::mpm {

// How water meets a body: it moves with its surface, or slides along it and may part from it.
enum class BodyContact { stick, slip };

// A body at the start of a simulation. Lengths in m; in 2D (x, z), and mass per metre of width.
template <int D>
struct RigidStart {
    Vector<D, double> size = Vector<D, double>::Zero();    // edges along the body's own axes, > 0
    Vector<D, double> center = Vector<D, double>::Zero();  // in the box
    double angle = 0.0;                                    // rad, turned in the x–z plane from x towards z
    double density = 920.0;                                // kg/m³
    BodyContact contact = BodyContact::slip;
    double friction = 0.0;                                   // Coulomb's coefficient, ≥ 0; slip
    Vector<D, double> velocity = Vector<D, double>::Zero();  // of its centre, m/s
    double spin = 0.0;                                       // rad/s, in the sense of angle
};

struct RigidBody {
    std::array<int, 3> anchor{};                       // node, (x, y, z) with y = 0 in 2D
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  // c from the anchor, m; y = 0 in 2D
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // V, m/s
    Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  // L about c, kg m²/s
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // ω, rad/s

    // What water and ice, and what walls and other bodies gave it since the start, kg m/s and kg m²/s.
    Eigen::Vector3d water_impulse = Eigen::Vector3d::Zero(), water_angular_impulse = Eigen::Vector3d::Zero();
    Eigen::Vector3d contact_impulse = Eigen::Vector3d::Zero();

    // What stays as it is.
    Eigen::Vector3d half_size = Eigen::Vector3d::Zero();  // h, m
    Eigen::Vector3d inertia = Eigen::Vector3d::Zero();    // I₁ … I₃, kg m²
    double mass = 0.0;                                    // M, kg
    BodyContact contact = BodyContact::slip;
    double friction = 0.0;
    std::vector<Eigen::Vector3d> surface;  // points on it, corners first, at most Δx apart; own axes, m

    Eigen::Vector3d center_in_box(double cell_size) const {  // m from the box's corner
        return center + cell_size * Eigen::Vector3d(anchor[0], anchor[1], anchor[2]);
    }
    Eigen::Vector3d velocity_at(const Eigen::Vector3d& arm) const {  // arm from the centre
        return velocity + angular_velocity.cross(arm);
    }
    double radius() const { return half_size.norm(); }
};

// The anchor as an index of D axes.
template <int D>
Index<D> anchor_of(const RigidBody& body) {
    if constexpr (D == 2)
        return {body.anchor[0], body.anchor[2]};
    else
        return {body.anchor[0], body.anchor[1], body.anchor[2]};
}

template <int D>
RigidBody make_rigid_body(const RigidStart<D>& start, double cell_size);

// c and R advance by dt.
void move_rigid_body(double dt, RigidBody& body);

Eigen::Matrix3d world_inertia(const RigidBody& body);

// ½ M V² + ½ ω·L, J.
double kinetic_energy(const RigidBody& body);

// Of its corners, the fastest points, m/s.
double max_speed(const RigidBody& body);

struct NodeShare {
    double value = 0.0;                               // s, from 0 to 1
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();  // ∇s, 1/m
};

// The share of the node at `arm` from the centre, m.
template <int D>
NodeShare share_of(const RigidBody& body, double cell_size, const Eigen::Vector3d& arm);

// The same with what the body's images beyond mirrors (mpm/grid/mirror.h) have of the node: on the plane of a
// mirror 1 within the body, though only half of that node's room is in the tank.
template <int D>
NodeShare share_of_node(const Layout<D>& layout, const RigidBody& body, const Index<D>& node);

// The nodes that the body or its images have a share of lie in this box, ends included; of those beyond
// mirrors three layers.
template <int D>
struct NodeRange {
    Index<D> first{}, last{};
};
template <int D>
NodeRange<D> reach_of(const Layout<D>& layout, const RigidBody& body);

// Points within the body on a lattice of about this spacing in its own axes, m in the box; they stand for the
// body in files and pictures. Always in the same order.
template <int D>
std::vector<Vector<D, double>> points_within(const RigidBody& body, double cell_size, double spacing);

}  // namespace tidewater::mpm
