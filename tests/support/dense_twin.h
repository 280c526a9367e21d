// The slow twin of the engine: one dense grid, double precision, one plain loop per equation of
// lib/mpm/README.md. No blocks, no sorting, no threads; what it shares with lib/mpm is the scene's
// Start and Eigen.
#pragma once

#include <cmath>
#include <vector>

#include "mpm/materials/water_material.h"
#include "mpm/step/crowding.h"
#include "mpm/step/start.h"
#include "mpm/step/step.h"
#include "support/dense_body.h"
#include "support/dense_ice.h"

namespace tidewater::test {

template <int D>
struct DenseTwin {
    using Vec = Vector<D, double>;
    using Mat = Matrix<D, double>;
    using Cell = mpm::Index<D>;
    struct Particle {
        std::size_t body;
        double mass, volume, j, alpha;
        Vec x, v;
        Mat c, b;
    };
    struct Node {
        double mass = 0;
        Vec momentum = Vec::Zero();
    };

    mpm::Start<D> start;
    std::vector<Particle> particles;
    std::vector<DenseBody<D>> rigid;
    std::vector<Node> grid;  // of the box and `rim` nodes around it, the last axis fastest
    double last_dt = 0.0;    // s, of the step before

    static constexpr int rim = 3;

    explicit DenseTwin(const mpm::Start<D>& from) : start(from) {
        for (std::size_t b = 0; b < start.bodies.size(); ++b) {
            const auto& body = start.bodies[b];
            const double count = static_cast<double>(body.points.size());
            for (std::size_t n = 0; n < body.points.size(); ++n) {
                Vec x = body.points[n];
                const mpm::WaterModel& model = start.parameters.water;
                const double g = start.parameters.gravity, depth = body.surface - x[D - 1];
                double j = 0.0, denser = 1.0;
                if (body.material == Material::water && !follows_room()) {
                    j = mpm::hydrostatic_j(depth, g, model);
                } else if (body.material == Material::water && body.surface > 0.0) {
                    denser = mpm::weighed_depth(body.surface, g, model) / body.surface;
                    x[D - 1] = body.surface - mpm::depth_of_weight(denser * depth, g, model);
                    j = mpm::j_under_weight(denser * depth, g, model);
                }
                particles.push_back({b, denser * body.mass / count, denser * body.volume / count, j,
                                     start.parameters.ice.initial_alpha(D), x,
                                     body.velocity.empty() ? Vec::Zero().eval() : body.velocity[n],
                                     body.gradient.empty() ? Mat::Zero().eval() : body.gradient[n],
                                     Mat::Identity()});
            }
        }
        for (const auto& body : start.rigid) rigid.emplace_back(body);
        // The start's velocities go to the grid once and come back as the first step reads them.
        scatter(0);
        for_each_image([&](Node& beyond, Node& image, const Vec& sign) { fold(sign, beyond, image); });
        for (Node& node : grid) node.momentum /= node.mass > 0 ? node.mass : 1;
        gather(0);
    }

    std::size_t index(const Cell& node) const {
        std::size_t n = 0;
        for (std::size_t axis = 0; axis < D; ++axis) {
            n = n * static_cast<std::size_t>(start.cells[axis] + 2 * rim + 1) +
                static_cast<std::size_t>(node[axis] + rim);
        }
        return n;
    }
    Cell node_at(std::size_t index) const {
        Cell node;
        for (std::size_t axis = D; axis-- > 0;) {
            const auto along = static_cast<std::size_t>(start.cells[axis] + 2 * rim + 1);
            node[axis] = static_cast<int>(index % along) - rim;
            index /= along;
        }
        return node;
    }

    Material material(const Particle& p) const { return start.bodies[p.body].material; }

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
        const double force_dt = 0.5 * (last_dt + dt);
        last_dt = dt;
        scatter(force_dt);
        for_each_image([&](Node& beyond, Node& image, const Vec& sign) { fold(sign, beyond, image); });
        for (Node& node : grid) {
            if (node.mass == 0) continue;
            node.momentum /= node.mass;  // velocity from here on
            node.momentum[D - 1] -= force_dt * start.parameters.gravity;
        }
        for (DenseBody<D>& body : rigid) meet(body, force_dt);
        for (std::size_t n = 0; n < grid.size(); ++n) apply_walls(node_at(n), grid[n].momentum);
        gather(dt);
    }

    // Velocities on the grid in, velocities out, of the nodes and of the body.
    void meet(DenseBody<D>& body, double dt) {
        body.velocity[2] -= dt * start.parameters.gravity;
        std::vector<typename DenseBody<D>::Touched> touched;
        for (std::size_t n = 0; n < grid.size(); ++n) {
            if (grid[n].mass == 0) continue;
            const auto share = share_at(body, node_at(n));
            if (share.value <= body.least_share()) continue;
            touched.push_back(
                body.touch(n, place_of(node_at(n)), grid[n].mass, grid[n].momentum, share, start.cell_size));
        }
        body.meet(touched);
        for (const auto& node : touched) grid[node.index].momentum = drop(node.velocity);
    }

    Vec place_of(const Cell& i) const {
        Vec x;
        for (std::size_t axis = 0; axis < D; ++axis) x[static_cast<int>(axis)] = start.cell_size * i[axis];
        return x;
    }

    // What the body and its images beyond walls that mirror have of a node.
    typename DenseBody<D>::Share share_at(const DenseBody<D>& body, const Cell& i) const {
        typename DenseBody<D>::Share sum{0, Vec::Zero()};
        // Each axis as it is, or through its first or its second wall.
        for (int k = 0; k < mpm::power(3, D); ++k) {
            Cell image = i;
            Vec sign = Vec::Ones();
            bool mirrored = true;
            for (std::size_t axis = 0, rest = static_cast<std::size_t>(k); axis < D; ++axis, rest /= 3) {
                if (rest % 3 == 0) continue;
                const std::size_t side = rest % 3 - 1;
                mirrored =
                    mirrored && start.parameters.boundaries.walls[axis][side] != mpm::WallRule::separate;
                image[axis] = (side == 0 ? 0 : 2 * start.cells[axis]) - i[axis];
                sign[static_cast<int>(axis)] = -1;
            }
            if (!mirrored) continue;
            const auto share = body.share(place_of(image), start.cell_size);
            sum.value += share.value;
            sum.slope += sign.cwiseProduct(share.slope);
        }
        return sum;
    }

    // Whether J follows the room that particles have (mpm/step/crowding.h); here only for water between
    // mirrors.
    bool follows_room() const { return start.parameters.water.scheme == mpm::WaterScheme::density; }

    // What water alone fills of a node in the box.
    double water_fill(const Cell& i) const {
        double full = start.parameters.water.density * std::pow(start.cell_size, D);
        for (std::size_t axis = 0; axis < D; ++axis) {
            if (i[axis] == 0 || i[axis] == start.cells[axis]) full /= 2;
        }
        return grid[index(i)].mass / full;
    }
    // By how much more than fits there is water at a node, or at its image in the box.
    std::vector<double> crowding;  // of every node
    double crowding_at(Cell i) const {
        for (std::size_t axis = 0; axis < D; ++axis) {
            const int last = start.cells[axis];
            if (i[axis] < 0) i[axis] = -i[axis];
            if (i[axis] > last) i[axis] = 2 * last - i[axis];
        }
        double fill = water_fill(i);
        for (const DenseBody<D>& body : rigid) fill += share_at(body, i).value;
        i[D - 1] += 1;
        return fill > mpm::min_fill || water_fill(i) > mpm::min_fill ? fill - 1 : 0;
    }
    double smooth_crowding(const Cell& i) const {
        double sum = 0;
        for (int k = 0; k < mpm::power(3, D); ++k) {
            Cell other = i;
            double share = 1;
            for (std::size_t axis = 0, rest = static_cast<std::size_t>(k); axis < D; ++axis, rest /= 3) {
                other[axis] += static_cast<int>(rest % 3) - 1;
                share *= rest % 3 == 1 ? 0.5 : 0.25;
            }
            sum += share * crowding[index(other)];
        }
        return sum;
    }

    // τ of a particle, Pa.
    Mat stress(const Particle& p) const {
        const mpm::WaterModel& water = start.parameters.water;
        const double j = 1 + p.j;
        switch (material(p)) {
            case Material::water:
                if (j > 1 && water.tension == mpm::WaterTension::separate) return Mat::Zero();
                return -j * water.bulk_modulus() * (std::pow(j, -water.exponent) - 1) * Mat::Identity();
            case Material::ice:
                return kirchhoff_stress<D>(start.parameters.ice, p.b);
            case Material::rigid:
                break;
        }
        return Mat::Zero();
    }

    void scatter(double dt) {
        const double dx = start.cell_size;
        Cell last;
        for (std::size_t axis = 0; axis < D; ++axis) last[axis] = start.cells[axis] + rim;
        grid.assign(index(last) + 1, Node{});
        for (const Particle& p : particles) {
            const Mat q = p.mass * p.c - dt * p.volume * 4 / (dx * dx) * stress(p);
            for_each_node(p.x, [&](const Cell& i, double w, const Vec& d) {
                Node& node = grid[index(i)];
                node.mass += w * p.mass;
                node.momentum += w * (p.mass * p.v + q * d);
            });
        }
    }

    void apply_walls(const Cell& i, Vec& v) const {
        for (int axis = 0; axis < D; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            for (int side = 0; side < 2; ++side) {
                if (side == 0 ? i[a] > 0 : i[a] < start.cells[a]) continue;
                const auto rule = start.parameters.boundaries.walls[a][static_cast<std::size_t>(side)];
                const double outward = side == 0 ? -1 : 1;
                if (rule == mpm::WallRule::stick) v.setZero();
                if (rule == mpm::WallRule::slip || v[axis] * outward > 0) v[axis] = 0;
            }
        }
    }

    // Calls visit(beyond, image, sign) for the nodes just beyond each wall that slips or sticks, wall after
    // wall: what is beyond is the image times sign.
    template <class Visit>
    void for_each_image(const Visit& visit) {
        for (int wall = 0; wall < 2 * D; ++wall) {
            const auto axis = static_cast<std::size_t>(wall / 2), side = static_cast<std::size_t>(wall % 2);
            const auto rule = start.parameters.boundaries.walls[axis][side];
            if (rule == mpm::WallRule::separate) continue;
            Vec sign = Vec::Constant(rule == mpm::WallRule::stick ? -1.0 : 1.0);
            sign[wall / 2] = -1;
            const int plane = side == 0 ? 0 : start.cells[axis], beyond = side == 0 ? -1 : plane + 1;
            for (std::size_t n = 0; n < grid.size(); ++n) {
                Cell node = node_at(n);
                if (node[axis] != beyond) continue;
                node[axis] = 2 * plane - beyond;
                visit(grid[n], grid[index(node)], sign);
            }
        }
    }

    static void fold(const Vec& sign, Node& beyond, Node& image) {
        image.mass += beyond.mass;
        image.momentum += sign.cwiseProduct(beyond.momentum);
        beyond = {};
    }

    void gather(double dt) {
        const double dx = start.cell_size;
        for_each_image([](Node& beyond, Node& image, const Vec& sign) {
            beyond.momentum = sign.cwiseProduct(image.momentum);
        });
        crowding.assign(grid.size(), 0);
        if (follows_room()) {
            for (std::size_t n = 0; n < grid.size(); ++n) crowding[n] = crowding_at(node_at(n));
        }
        for (Particle& p : particles) {
            p.v.setZero();
            p.c.setZero();
            for_each_node(p.x, [&](const Cell& i, double w, const Vec& d) {
                const Vec& u = grid[index(i)].momentum;
                p.v += w * u;
                p.c += 4 / (dx * dx) * w * u * d.transpose();
            });
            double made_good = 0;
            if (material(p) == Material::water && follows_room()) {
                double e = 0;
                for_each_node(p.x, [&](const Cell& i, double w, const Vec&) { e += w * smooth_crowding(i); });
                const double fall = std::sqrt(dx / start.parameters.gravity);
                made_good = std::min(dt / fall, mpm::max_crowding_rate) * (1 / (1 + e) - 1 - p.j);
            }
            p.x += dt * p.v;
            const double growth = dt * p.c.trace();
            p.j += (1 + p.j) * (follows_room() ? std::max(growth, mpm::min_growth) : growth) + made_good;
            if (follows_room()) p.j = std::min(p.j, mpm::max_j);
            const Mat change = Mat::Identity() + dt * p.c;
            p.b = change * p.b * change.transpose();
            const bool may_fail = material(p) == Material::ice && start.parameters.ice.fracture;
            if (may_fail) return_to_yield<D>(start.parameters.ice, p.b, p.alpha);
        }
        for (DenseBody<D>& body : rigid) body.move(dt);
    }

    static Vec drop(const Eigen::Vector3d& v) {
        if constexpr (D == 3)
            return v;
        else
            return {v[0], v[2]};
    }
};

}  // namespace tidewater::test
