// The slow twin of the engine: one dense grid, double precision, one plain loop per equation of
// shared/physics.md §1–§5. No blocks, no sorting, no threads; what it shares with lib/mpm is the scene's
// Start and Eigen.
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "mpm/start.h"

namespace tidewater::test {

template <int D>
struct DenseTwin {
    using Vec = Vector<D, double>;
    using Mat = Matrix<D, double>;
    using Cell = mpm::Index<D>;
    struct Particle {
        std::size_t body;
        double mass, volume, j;
        Vec x, v, r0;
        Mat c;
    };
    struct Node {
        double mass = 0;
        Vec momentum = Vec::Zero();
    };

    mpm::Start<D> start;
    std::vector<Particle> particles;
    std::vector<Vec> center;                   // of each body
    std::vector<Eigen::Quaterniond> rotation;  // of each body
    std::map<Cell, Node> grid;

    explicit DenseTwin(const mpm::Start<D>& from) : start(from) {
        for (std::size_t b = 0; b < start.bodies.size(); ++b) {
            const auto& body = start.bodies[b];
            const double count = static_cast<double>(body.points.size());
            Vec middle = Vec::Zero();
            for (const Vec& x : body.points) middle += x / count;
            center.push_back(middle);
            rotation.push_back(Eigen::Quaterniond::Identity());
            for (const Vec& x : body.points) {
                const bool water = body.material == Material::water;
                const double depth = body.surface - x[D - 1];
                const double j =
                    water ? mpm::hydrostatic_j(depth, start.parameters.gravity, start.parameters.water) : 0.0;
                particles.push_back(
                    {b, body.mass / count, body.volume / count, j, x, Vec::Zero(), x - middle, Mat::Zero()});
            }
        }
    }

    bool is_water(const Particle& p) const { return start.bodies[p.body].material == Material::water; }

    // Calls visit(node, weight, x_i − x_p) for the 3^D nodes of a particle.
    template <class Visit>
    void for_each_node(const Vec& x, const Visit& visit) const {
        const double dx = start.cell_size;
        for (int k = 0; k < mpm::power(3, D); ++k) {
            Cell node;
            Vec d;
            double w = 1;
            for (int axis = D - 1, rest = k; axis >= 0; --axis, rest /= 3) {
                const int first = static_cast<int>(std::floor(x[axis] / dx - 0.5));
                node[static_cast<std::size_t>(axis)] = first + rest % 3;
                const double r = std::abs(first + rest % 3 - x[axis] / dx);
                w *= r < 0.5 ? 0.75 - r * r : 0.5 * (1.5 - r) * (1.5 - r);
                d[axis] = (first + rest % 3) * dx - x[axis];
            }
            visit(node, w, d);
        }
    }

    void step(double dt) {
        const double dx = start.cell_size, theta = start.parameters.water.exponent;
        grid.clear();
        for (const Particle& p : particles) {
            const double j = 1 + p.j;
            const double tau =
                is_water(p) ? -j * start.parameters.water.bulk_modulus() * (std::pow(j, -theta) - 1) : 0;
            const Mat q = p.mass * p.c - dt * p.volume * 4 / (dx * dx) * tau * Mat::Identity();
            for_each_node(p.x, [&](const Cell& i, double w, const Vec& d) {
                grid[i].mass += w * p.mass;
                grid[i].momentum += w * (p.mass * p.v + q * d);
            });
        }
        for (auto& [i, node] : grid) {
            node.momentum /= node.mass;  // velocity from here on
            node.momentum[D - 1] -= dt * start.parameters.gravity;
        }
        for (std::size_t b = 0; b < start.bodies.size(); ++b) {
            if (start.bodies[b].material == Material::rigid && !start.bodies[b].points.empty())
                move_nodes_as_one(b);
        }
        for (auto& [i, node] : grid) {
            Vec& v = node.momentum;
            for (int axis = 0; axis < D; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                for (int side = 0; side < 2; ++side) {
                    if (side == 0 ? i[a] > 0 : i[a] < start.cells[a]) continue;
                    const auto rule = start.parameters.walls[a][static_cast<std::size_t>(side)];
                    const double outward = side == 0 ? -1 : 1;
                    if (rule == mpm::WallRule::stick) v.setZero();
                    if (rule == mpm::WallRule::slip || v[axis] * outward > 0) v[axis] = 0;
                }
            }
        }
        for (Particle& p : particles) {
            p.v.setZero();
            p.c.setZero();
            for_each_node(p.x, [&](const Cell& i, double w, const Vec& d) {
                p.v += w * grid[i].momentum;
                p.c += 4 / (dx * dx) * w * grid[i].momentum * d.transpose();
            });
            if (!is_water(p)) continue;
            p.j += (1 + p.j) * dt * p.c.trace();
            p.x += dt * p.v;
        }
        for (std::size_t b = 0; b < start.bodies.size(); ++b) {
            if (start.bodies[b].material == Material::rigid && !start.bodies[b].points.empty())
                move_rigid(b, dt);
        }
    }

    static Eigen::Vector3d lift(const Vec& v) {
        if constexpr (D == 3)
            return v;
        else
            return {v[0], 0, v[1]};
    }
    static Vec drop(const Eigen::Vector3d& v) {
        if constexpr (D == 3)
            return v;
        else
            return {v[0], v[2]};
    }

    // Every node that a body fills by 1/48 or more takes part in one rigid motion with the momentum of these
    // nodes.
    void move_nodes_as_one(std::size_t body) {
        std::map<Cell, double> filled;
        for (const Particle& p : particles) {
            if (p.body != body) continue;
            for_each_node(p.x, [&](const Cell& i, double w, const Vec&) {
                filled[i] += w * p.volume / std::pow(start.cell_size, D);
            });
        }
        std::map<Cell, Eigen::Vector3d> touched;
        for (const auto& [i, share] : filled) {
            if (share <= 1.0 / 48.0) continue;
            Vec x;
            for (int axis = 0; axis < D; ++axis)
                x[axis] = i[static_cast<std::size_t>(axis)] * start.cell_size;
            touched[i] = lift(x);
        }
        double mass = 0;
        Eigen::Vector3d middle = Eigen::Vector3d::Zero(), linear = middle, angular = middle;
        for (const auto& [i, x] : touched) {
            mass += grid[i].mass;
            middle += grid[i].mass * x;
            linear += grid[i].mass * lift(grid[i].momentum);
        }
        middle /= mass;
        Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
        for (const auto& [i, x] : touched) {
            const Eigen::Vector3d r = x - middle;
            turn += grid[i].mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
            angular += grid[i].mass * r.cross(lift(grid[i].momentum));
        }
        const Eigen::Vector3d omega = turn.inverse() * angular;
        for (const auto& [i, x] : touched) grid[i].momentum = drop(linear / mass + omega.cross(x - middle));
    }

    Eigen::Matrix3d inertia(std::size_t body) const {
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (const Particle& p : particles) {
            if (p.body != body) continue;
            const Eigen::Vector3d r = rotation[body] * lift(p.r0);
            sum += p.mass *
                   ((r.squaredNorm() + start.cell_size * start.cell_size / 2) * Eigen::Matrix3d::Identity() -
                    r * r.transpose());
        }
        return sum;
    }

    void move_rigid(std::size_t body, double dt) {
        double mass = 0;
        Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear;
        for (const Particle& p : particles) {
            if (p.body != body) continue;
            mass += p.mass;
            linear += p.mass * lift(p.v);
            Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
            for (int col = 0; col < D; ++col) c.col(D == 2 ? 2 * col : col) = lift(p.c.col(col));
            const Eigen::Vector3d twice_axial(c(2, 1) - c(1, 2), c(0, 2) - c(2, 0), c(1, 0) - c(0, 1));
            angular += p.mass * ((lift(p.x) - lift(center[body])).cross(lift(p.v)) +
                                 start.cell_size * start.cell_size / 4 * twice_axial);
        }
        const Eigen::Vector3d velocity = linear / mass;
        Eigen::Vector3d omega = inertia(body).inverse() * angular;
        center[body] += dt * drop(velocity);
        if (omega.norm() > 0) {
            const Eigen::AngleAxisd turn(dt * omega.norm(), omega.normalized());
            rotation[body] = Eigen::Quaterniond(turn) * rotation[body];
            omega = inertia(body).inverse() * angular;
        }
        Eigen::Matrix3d cross;
        cross << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
        for (Particle& p : particles) {
            if (p.body != body) continue;
            const Eigen::Vector3d r = rotation[body] * lift(p.r0);
            p.x = center[body] + drop(r);
            p.v = drop(velocity + omega.cross(r));
            for (int col = 0; col < D; ++col) p.c.col(col) = drop(cross.col(D == 2 ? 2 * col : col));
        }
    }
};

}  // namespace tidewater::test
