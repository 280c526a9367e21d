#include "mpm/rigid.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mpm/lift.h"
#include "mpm/motion.h"

namespace tidewater::mpm {
namespace {

// ε:Gᵀ, twice the axial vector of a velocity gradient.
template <int D>
Eigen::Vector3d twice_axial(const Matrix<D, double>& g) {
    if constexpr (D == 3)
        return {g(2, 1) - g(1, 2), g(0, 2) - g(2, 0), g(1, 0) - g(0, 1)};
    else
        return {0.0, g(0, 1) - g(1, 0), 0.0};
}

// [ω]× as it acts in D dimensions.
template <int D>
Matrix<D, double> cross_matrix(const Eigen::Vector3d& w) {
    Matrix<D, double> m;
    if constexpr (D == 3)
        m << 0.0, -w[2], w[1], w[2], 0.0, -w[0], -w[1], w[0], 0.0;
    else
        m << 0.0, w[1], -w[1], 0.0;
    return m;
}

// The particle blocks that hold particles of the body, rising in x, then y, then z: an order that stays when
// the scene is moved, which that of Morton keys does not.
template <int D, class Real>
std::vector<std::size_t> blocks_of_body(const Grid<D, Real>& grid, const Particles<D, Real>& particles) {
    std::vector<std::size_t> slots;
    for (std::size_t slot = 0; slot < grid.particle_blocks.size(); ++slot) {
        if (particles.begin[slot] < particles.begin[slot + 1]) slots.push_back(slot);
    }
    std::sort(slots.begin(), slots.end(), [&](std::size_t a, std::size_t b) {
        return block_at<D>(grid.particle_blocks[a]) < block_at<D>(grid.particle_blocks[b]);
    });
    return slots;
}

struct Momenta {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};

// Summed per block in parallel, then over the blocks in the order of their places.
template <int D, class Real>
Momenta gathered_momenta(const Grid<D, Real>& grid, const RigidBody& body,
                         const Particles<D, Real>& particles) {
    std::vector<Momenta> of_block(grid.particle_blocks.size());
    const double dx = grid.layout.cell_size;
    const Index<D> anchor = anchor_of<D>(body);
    for_each_motion(grid, particles,
                    [&](std::size_t slot, const Index<D>& block, std::size_t p, const Vector<D, Real>& v,
                        const Matrix<D, Real>& g) {
                        const Eigen::Vector3d arm =
                            lift<D>(global_position(grid.layout, block, particles, p, anchor)) - body.center;
                        const Eigen::Vector3d velocity = lift<D>(v.template cast<double>());
                        of_block[slot].linear += velocity;
                        of_block[slot].angular +=
                            arm.cross(velocity) + 0.25 * dx * twice_axial<D>(g.template cast<double>());
                    });
    Momenta total;
    for (const std::size_t slot : blocks_of_body(grid, particles)) {
        total.linear += particles.mass * of_block[slot].linear;
        total.angular += particles.mass * of_block[slot].angular;
    }
    return total;
}

// The particles of one block that lie beyond one wall.
struct Beyond {
    double count = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // of their positions, m
    double deepest = 0.0;                           // m beyond the wall
};

// Where the body touches the wall of `axis` at `plane` (m from the anchor) on the side `outward` (−1 or 1);
// count 0 if it does not.
template <int D, class Real>
Beyond find_contact(const Grid<D, Real>& grid, const Particles<D, Real>& particles, const Index<D>& anchor,
                    int axis, double outward, double plane) {
    std::vector<Beyond> of_block(grid.particle_blocks.size());
    for_each_particle(grid, particles, [&](std::size_t slot, const Index<D>& block, std::size_t p) {
        const Vector<D, double> point = global_position(grid.layout, block, particles, p, anchor);
        const double depth = outward * (point[axis] - plane);
        if (depth <= 0.0) return;
        of_block[slot].deepest = std::max(of_block[slot].deepest, depth);
        of_block[slot].count += 1.0;
        of_block[slot].sum += lift<D>(point);
    });
    Beyond total;
    for (const std::size_t slot : blocks_of_body(grid, particles)) {
        const Beyond& beyond = of_block[slot];
        total.count += beyond.count;
        total.sum += beyond.sum;
        total.deepest = std::max(total.deepest, beyond.deepest);
    }
    return total;
}

Eigen::Matrix3d turned_inertia(const RigidBody& body) {
    const Eigen::Matrix3d r = body.rotation.toRotationMatrix();
    return r * body.inertia * r.transpose();
}

// Stops the body at every wall that it reaches.
template <int D, class Real>
WallContact stop_at_walls(const Grid<D, Real>& grid, const Particles<D, Real>& particles, RigidBody& body) {
    WallContact contact;
    const Index<D> anchor = anchor_of<D>(body);
    for (int wall = 0; wall < 2 * D; ++wall) {
        const int axis = wall / 2;
        const auto a = static_cast<std::size_t>(axis);
        const double outward = wall % 2 == 0 ? -1.0 : 1.0;
        const double plane = grid.layout.cell_size * ((wall % 2 == 0 ? 0 : grid.layout.cells[a]) - anchor[a]);
        if (outward * (drop<D>(body.center)[axis] - plane) + body.radius < 0.0) continue;
        const Beyond beyond = find_contact(grid, particles, anchor, axis, outward, plane);
        if (beyond.count == 0.0) continue;
        const Eigen::Vector3d normal = lift<D>(Vector<D, double>::Unit(axis) * outward);
        const Eigen::Vector3d arm = beyond.sum / beyond.count - body.center;
        const double correction = std::min(beyond.deepest, greatest_correction * grid.layout.cell_size);
        body.center -= correction * normal;
        contact.correction = std::max(contact.correction, correction);
        const double approach = (body.velocity + body.angular_velocity.cross(arm)).dot(normal);
        if (approach <= 0.0) continue;
        const Eigen::Vector3d lever = arm.cross(normal);
        const Eigen::LDLT<Eigen::Matrix3d> inertia = turned_inertia(body).ldlt();
        const Eigen::Vector3d push = -approach / (1.0 / body.mass + lever.dot(inertia.solve(lever))) * normal;
        body.velocity += push / body.mass;
        body.angular_momentum += arm.cross(push);
        body.angular_velocity = inertia.solve(body.angular_momentum);
        contact.impulse += push;
    }
    return contact;
}

}  // namespace

template <int D, class Real>
RigidBody make_rigid_body(const std::vector<Vector<D, double>>& points, double cell_size,
                          Particles<D, Real>& particles) {
    RigidBody body;
    body.mass = particles.mass * static_cast<double>(points.size());
    for (int axis = 0; axis < D; ++axis) {
        const int block = static_cast<int>(std::floor(points[0][axis] / cell_size / Block<D>::width));
        body.anchor[static_cast<std::size_t>(axis == D - 1 ? 2 : axis)] = block * Block<D>::width;
    }
    const Eigen::Vector3d anchor =
        cell_size * Eigen::Vector3d(body.anchor[0], body.anchor[1], body.anchor[2]);
    for (const auto& point : points) body.center += lift<D>(point) - anchor;
    body.center /= static_cast<double>(points.size());
    particles.offset.clear();
    for (const auto& point : points) {
        const Eigen::Vector3d r = lift<D>(point) - anchor - body.center;
        body.inertia +=
            particles.mass * ((r.squaredNorm() + 0.5 * cell_size * cell_size) * Eigen::Matrix3d::Identity() -
                              r * r.transpose());
        body.radius = std::max(body.radius, r.norm());
        particles.offset.push_back(drop<D>(r).template cast<Real>());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(body.inertia, Eigen::EigenvaluesOnly);
    const double least = D == 2 ? body.inertia(1, 1) : principal.eigenvalues()[0];
    body.swing = std::sqrt(1.0 + body.mass * body.radius * body.radius / least);
    return body;
}

template <int D, class Real>
WallContact take_over_momentum(const Grid<D, Real>& grid, const Particles<D, Real>& particles,
                               RigidBody& body) {
    const Momenta momenta = gathered_momenta(grid, body, particles);
    body.velocity = momenta.linear / body.mass;
    body.angular_momentum = momenta.angular;
    body.angular_velocity = turned_inertia(body).ldlt().solve(body.angular_momentum);
    return stop_at_walls(grid, particles, body);
}

void move_rigid_body(double dt, RigidBody& body) {
    body.center += dt * body.velocity;
    const double angle = dt * body.angular_velocity.norm();
    if (angle > 0.0) {
        const Eigen::AngleAxisd turn(angle, body.angular_velocity.normalized());
        body.rotation = (Eigen::Quaterniond(turn) * body.rotation).normalized();
        body.angular_velocity = turned_inertia(body).ldlt().solve(body.angular_momentum);
    }
}

template <int D, class Real>
void scatter_rigid(const Layout<D>& layout, const RigidBody& body, const Index<D>& block, std::size_t slot,
                   Particles<D, Real>& particles, Node<Real>* tile) {
    const Eigen::Matrix3d rotation = body.rotation.toRotationMatrix();
    const auto mass = static_cast<Real>(particles.mass);
    const Matrix<D, Real> gradient =
        mass * (layout.cell_size * cross_matrix<D>(body.angular_velocity)).template cast<Real>();
    const Index<D> anchor = anchor_of<D>(body);
    for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
        const Eigen::Vector3d arm = rotation * lift<D>(particles.offset[p].template cast<double>());
        const Vector<D, double> point = drop<D>(body.center + arm);
        for (std::size_t axis = 0; axis < D; ++axis) {
            const int first = layout.first_node(block[axis]) - anchor[axis];
            const double cells = point[static_cast<int>(axis)] / layout.cell_size - first;
            particles.position[axis][p] = stored<Real>(cells);
        }
        const Vector<D, double> velocity = drop<D>(body.velocity + body.angular_velocity.cross(arm));
        scatter<D, Real>(local_position<D, Real>(particles, p), mass, mass * velocity.template cast<Real>(),
                         gradient, tile);
    }
}

double RigidBody::speed_bound() const { return swing * std::sqrt(2.0 * kinetic_energy(*this) / mass); }

double kinetic_energy(const RigidBody& body) {
    return 0.5 * body.mass * body.velocity.squaredNorm() +
           0.5 * body.angular_velocity.dot(body.angular_momentum);
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                      \
    template RigidBody make_rigid_body(const std::vector<Vector<D, double>>&, double, Particles<D, Real>&); \
    template WallContact take_over_momentum(const Grid<D, Real>&, const Particles<D, Real>&, RigidBody&);   \
    template void scatter_rigid<D, Real>(const Layout<D>&, const RigidBody&, const Index<D>&, std::size_t,  \
                                         Particles<D, Real>&, Node<Real>*);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
