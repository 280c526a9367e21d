#include "mpm/rigid.h"

#include <algorithm>
#include <cmath>

#include "mpm/lift.h"

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

struct Momenta {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};

// Summed per block in parallel, then over the blocks in order.
template <int D, class Real>
Momenta gathered_momenta(const Grid<D, Real>& grid, const RigidBody& body,
                         const Particles<D, Real>& particles) {
    std::vector<Momenta> of_block(grid.particle_blocks.size());
    const double dx = grid.layout.cell_size;
    parallel_for(of_block.size(), [&](std::size_t slot) {
        const Index<D> block = grid.layout.block_at(grid.particle_blocks[slot]);
        Momenta& sum = of_block[slot];
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            const Eigen::Vector3d arm =
                lift<D>(global_position<D, Real>(grid.layout, block, particles.position[p])) - body.center;
            const Eigen::Vector3d velocity = lift<D>(particles.velocity[p].template cast<double>());
            const Matrix<D, double> gradient = particles.gradient[p].template cast<double>();  // Δx C
            sum.linear += velocity;
            sum.angular += arm.cross(velocity) + 0.25 * dx * twice_axial<D>(gradient);
        }
    });
    Momenta total;
    for (const Momenta& sum : of_block) {
        total.linear += particles.mass * sum.linear;
        total.angular += particles.mass * sum.angular;
    }
    return total;
}

// The particles of one block that lie beyond one wall.
struct Beyond {
    double count = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // of their positions, m
    double deepest = 0.0;                           // m beyond the wall
};

// Where the body touches the wall of `axis` at `plane` (m) on the side `outward` (−1 or 1); count 0 if it
// does not.
template <int D, class Real>
Beyond find_contact(const Grid<D, Real>& grid, const Particles<D, Real>& particles, int axis, double outward,
                    double plane) {
    std::vector<Beyond> of_block(grid.particle_blocks.size());
    parallel_for(of_block.size(), [&](std::size_t slot) {
        const Index<D> block = grid.layout.block_at(grid.particle_blocks[slot]);
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            const Vector<D, double> point =
                global_position<D, Real>(grid.layout, block, particles.position[p]);
            const double depth = outward * (point[axis] - plane);
            if (depth <= 0.0) continue;
            of_block[slot].deepest = std::max(of_block[slot].deepest, depth);
            of_block[slot].count += 1.0;
            of_block[slot].sum += lift<D>(point);
        }
    });
    Beyond total;
    for (const Beyond& beyond : of_block) {
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

}  // namespace

template <int D, class Real>
RigidBody make_rigid_body(const std::vector<Vector<D, double>>& points, double cell_size,
                          Particles<D, Real>& particles) {
    RigidBody body;
    body.mass = particles.mass * static_cast<double>(points.size());
    for (const auto& point : points) body.center += lift<D>(point);
    body.center /= static_cast<double>(points.size());
    particles.offset.clear();
    for (const auto& point : points) {
        const Eigen::Vector3d r = lift<D>(point) - body.center;
        body.inertia +=
            particles.mass * ((r.squaredNorm() + 0.5 * cell_size * cell_size) * Eigen::Matrix3d::Identity() -
                              r * r.transpose());
        body.radius = std::max(body.radius, r.norm());
        particles.offset.push_back(drop<D>(r).template cast<Real>());
    }
    return body;
}

// Stops the body at every wall that it reaches; returns the impulse that it got.
template <int D, class Real>
Eigen::Vector3d stop_at_walls(const Grid<D, Real>& grid, const Particles<D, Real>& particles,
                              RigidBody& body) {
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
    for (int wall = 0; wall < 2 * D; ++wall) {
        const int axis = wall / 2;
        const double outward = wall % 2 == 0 ? -1.0 : 1.0;
        const double plane =
            wall % 2 == 0 ? 0.0 : grid.layout.cell_size * grid.layout.cells[static_cast<std::size_t>(axis)];
        if (outward * (drop<D>(body.center)[axis] - plane) + body.radius < 0.0) continue;
        const Beyond beyond = find_contact(grid, particles, axis, outward, plane);
        if (beyond.count == 0.0) continue;
        const Eigen::Vector3d normal = lift<D>(Vector<D, double>::Unit(axis) * outward);
        const Eigen::Vector3d arm = beyond.sum / beyond.count - body.center;
        body.center -= beyond.deepest * normal;
        const double approach = (body.velocity + body.angular_velocity.cross(arm)).dot(normal);
        if (approach <= 0.0) continue;
        const Eigen::Vector3d lever = arm.cross(normal);
        const Eigen::LDLT<Eigen::Matrix3d> inertia = turned_inertia(body).ldlt();
        const Eigen::Vector3d push = -approach / (1.0 / body.mass + lever.dot(inertia.solve(lever))) * normal;
        body.velocity += push / body.mass;
        body.angular_momentum += arm.cross(push);
        body.angular_velocity = inertia.solve(body.angular_momentum);
        impulse += push;
    }
    return impulse;
}

template <int D, class Real>
RigidMotion move_rigid_body(const Grid<D, Real>& grid, double dt, RigidBody& body,
                            Particles<D, Real>& particles) {
    const Momenta momenta = gathered_momenta(grid, body, particles);
    body.velocity = momenta.linear / body.mass;
    body.angular_momentum = momenta.angular;
    body.angular_velocity = turned_inertia(body).ldlt().solve(body.angular_momentum);
    RigidMotion motion;
    motion.wall_impulse = stop_at_walls(grid, particles, body);

    body.center += dt * body.velocity;
    const double angle = dt * body.angular_velocity.norm();
    if (angle > 0.0) {
        const Eigen::AngleAxisd turn(angle, body.angular_velocity.normalized());
        body.rotation = (Eigen::Quaterniond(turn) * body.rotation).normalized();
        body.angular_velocity = turned_inertia(body).ldlt().solve(body.angular_momentum);
    }

    const Eigen::Matrix3d rotation = body.rotation.toRotationMatrix();
    const Matrix<D, Real> gradient =
        (grid.layout.cell_size * cross_matrix<D>(body.angular_velocity)).template cast<Real>();
    std::vector<double> greatest(grid.particle_blocks.size(), 0.0);
    parallel_for(greatest.size(), [&](std::size_t slot) {
        const Index<D> block = grid.layout.block_at(grid.particle_blocks[slot]);
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            const Eigen::Vector3d arm = rotation * lift<D>(particles.offset[p].template cast<double>());
            const Vector<D, double> velocity = drop<D>(body.velocity + body.angular_velocity.cross(arm));
            particles.position[p] = local_position<D, Real>(grid.layout, block, drop<D>(body.center + arm));
            particles.velocity[p] = velocity.template cast<Real>();
            particles.gradient[p] = gradient;
            greatest[slot] = std::max(greatest[slot], velocity.squaredNorm());
        }
    });
    motion.greatest_speed = std::sqrt(*std::max_element(greatest.begin(), greatest.end()));
    return motion;
}

double kinetic_energy(const RigidBody& body) {
    return 0.5 * body.mass * body.velocity.squaredNorm() +
           0.5 * body.angular_velocity.dot(body.angular_momentum);
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                      \
    template RigidBody make_rigid_body(const std::vector<Vector<D, double>>&, double, Particles<D, Real>&); \
    template RigidMotion move_rigid_body(const Grid<D, Real>&, double, RigidBody&, Particles<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
