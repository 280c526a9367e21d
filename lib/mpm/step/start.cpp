#include "mpm/step/start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "mpm/base/instantiate.h"
#include "mpm/materials/materials.h"
#include "mpm/particles/binning.h"
#include "mpm/particles/motion.h"
#include "mpm/step/crowding.h"
#include "mpm/step/time_step.h"

namespace tidewater::mpm {
namespace {

// The depth at which each point of a body of water starts, m: its head, or how far it lies below the surface.
template <int D>
std::vector<double> depths(const typename Start<D>::Body& body) {
    if (!body.head.empty()) return body.head;
    std::vector<double> depth;
    for (const auto& point : body.points) depth.push_back(body.surface - point[D - 1]);
    return depth;
}

// Compresses water of the scheme `density` by its weight: equal masses lie closer together the deeper they
// are, so that volumes and room agree from the start. The points move within their column, between its bottom
// and the surface, and the body's mass becomes that of columns so filled. Returns j of each point.
template <int D>
std::vector<double> compress(const Start<D>& start, typename Start<D>::Body& body) {
    const WaterModel& water = start.parameters.water;
    const double gravity = start.parameters.gravity;
    std::vector<double> j = depths<D>(body);
    // The mean over the points of their column's mass over that of water without weight.
    double denser = 0.0;
    for (std::size_t p = 0; p < j.size(); ++p) {
        const double depth = std::max(j[p], 0.0);
        double& z = body.points[p][D - 1];
        const Bed<D>& bed = start.parameters.boundaries.bed;
        const double ground =
            bed.exists() ? std::max(bed.height(body.points[p].template head<D - 1>()), 0.0) : 0.0;
        const double column = std::max(z - ground, 0.0) + depth;
        const double mean = depth > 0.0 ? weighed_depth(column, gravity, water) / column : 1.0;
        if (depth > 0.0) z += depth - depth_of_weight(mean * depth, gravity, water);
        j[p] = j_under_weight(mean * depth, gravity, water);
        denser += mean;
    }
    denser /= static_cast<double>(j.size());
    body.mass *= denser;
    body.volume *= denser;  // at rest
    return j;
}

// Returns j of each point of a body of water in hydrostatic balance. The scheme `density` moves its points.
template <int D>
std::vector<double> hydrostatic_columns(const Start<D>& start, typename Start<D>::Body& body) {
    if (start.parameters.water.scheme == WaterScheme::density) return compress(start, body);
    std::vector<double> j = depths<D>(body);
    for (double& h : j) h = hydrostatic_j(h, start.parameters.gravity, start.parameters.water);
    return j;
}

// Sets α = −asinh(p0/κ)/ξ of each point that is weaker than intact ice; ice without strength has failed at
// time 0.
template <int D, class Real>
void weaken(const IceModel& ice, const std::vector<float>& strength, Particles<D, Real>& particles) {
    const double share_of_kappa = std::sinh(-ice.hardening * ice.initial_alpha(D));
    for (std::size_t p = 0; p < strength.size(); ++p) {
        const double left = strength[p];
        if (left >= 1.0) continue;
        particles.alpha[p] = static_cast<Real>(-std::asinh(left * share_of_kappa) / ice.hardening);
        if (left <= 0.0) particles.failure_time[p] = Real(0);
    }
}

// Makes the columns that the material keeps, in the order of the points.
//     j  of each point of water; empty for other materials
template <int D, class Real>
void fill_columns(const Start<D>& start, const typename Start<D>::Body& body, const std::vector<double>& j,
                  Particles<D, Real>& particles) {
    with_material<D, Real>(particles.material, [&]<class M>(std::type_identity<M>) {
        M::make_columns(M::model(start.parameters), body.points.size(), particles);
    });
    for (std::size_t p = 0; p < j.size(); ++p) particles.j[p] = static_cast<Real>(j[p]);
    if (particles.material == Material::ice && start.parameters.ice.fracture)
        weaken(start.parameters.ice, body.strength, particles);
}

// Brings the start's velocities to the nodes and returns max. |v| of each block of nodes, m/s.
template <int D, class Real>
std::vector<double> scatter_start(const Start<D>& start,
                                  const std::vector<const typename Start<D>::Body*>& bodies,
                                  Simulation<D, Real>& s) {
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        Node<Real>* tile = s.grid.tile(slot);
        std::fill_n(tile, Block<D>::tile_size, Node<Real>::Zero());
        std::uint32_t first_id = 0;  // of the body; its ids count up from there
        for (std::size_t body = 0; body < bodies.size(); ++body) {
            const auto& particles = s.bodies[body];
            const auto& velocity = bodies[body]->velocity;
            const auto& gradient = bodies[body]->gradient;
            Tile<D, Real> own;
            own.fill(Node<Real>::Zero());
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                const std::size_t point = particles.id[p] - first_id;
                Vector<D, double> momentum = Vector<D, double>::Zero();
                Matrix<D, double> change = Matrix<D, double>::Zero();
                if (!velocity.empty()) momentum = particles.mass * velocity[point];
                if (!gradient.empty()) change = particles.mass * start.cell_size * gradient[point];
                scatter<D, Real>(local_position(particles, p), static_cast<Real>(particles.mass),
                                 momentum.template cast<Real>(), change.template cast<Real>(), own.data());
            }
            fold<D, Real>(s.grid.layout, block_at<D>(s.grid.particle_blocks[slot]), Parity::velocity,
                          own.data());
            for (std::size_t n = 0; n < own.size(); ++n) tile[n] += own[n];
            first_id += static_cast<std::uint32_t>(particles.size());
        }
    });
    std::vector<double> max_of_block(s.grid.node_blocks.size(), 0.0);  // not finite if a speed is not
    parallel_for(max_of_block.size(), [&](std::size_t slot) {
        Node<Real>* nodes = s.grid.block_nodes(slot);
        sum_tiles<D, Real>(s.grid.tiles_of_node[slot], s.grid.tiles.data(), nodes);
        momentum_to_velocity<D, Real>(Real(0), nodes);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const double speed = static_cast<double>(nodes[n].template head<D>().matrix().norm());
            if (!(speed <= max_of_block[slot])) max_of_block[slot] = speed;
            if (!std::isfinite(speed)) return;
        }
    });
    for (const double speed : max_of_block) {
        if (!std::isfinite(speed)) throw NumericsError("a velocity of the start is not a number");
        s.speeds.particle = std::max(s.speeds.particle, speed);
    }
    return max_of_block;
}

}  // namespace

template <int D, class Real>
Simulation<D, Real> make_simulation(Start<D> start) {
    Simulation<D, Real> s;
    s.parameters = start.parameters;
    s.grid.layout = Layout<D>{start.cell_size, start.cells, mirrors_of(start.parameters.boundaries)};
    s.parameters.boundaries.bed.keep_grounds(s.grid.layout);
    std::vector<const typename Start<D>::Body*> bodies;
    std::vector<std::span<const Vector<D, double>>> points;
    Findings findings;
    for (auto& body : start.bodies) {
        if (body.points.empty()) continue;
        std::vector<double> j;
        if (body.material == Material::water) j = hydrostatic_columns(start, body);
        bodies.push_back(&body);
        points.emplace_back(body.points);
        Particles<D, Real>& particles = s.bodies.emplace_back();
        const auto count = static_cast<double>(body.points.size());
        particles.material = body.material;
        particles.mass = body.mass / count;
        particles.volume = body.volume / count;
        for (const double of_point : j) findings.add({.min_j = of_point});
        fill_columns(start, body, j, particles);
    }
    const Signal sound = fastest_sound(s.parameters, s.bodies, findings);
    s.speeds.sound = sound.sound;
    place<D, Real>(points, s.grid, s.bodies);
    s.unknown_fill = find_unknown_fill(s.parameters, s.time, s.grid, s.bodies);
    const std::vector<double> node_speed = scatter_start(start, bodies, s);
    for (const RigidStart<D>& body : start.rigid) {
        s.rigid.push_back(make_rigid_body(body, start.cell_size));
        s.speeds.particle = std::max(s.speeds.particle, max_speed(s.rigid.back()));
    }
    // The sound of each block is known from the first pass on.
    const std::vector<Signal> of_block(s.grid.particle_blocks.size(), sound);
    s.drift.assign(of_block.size(), 0.0);
    s.speeds.signal = find_signal(s.grid, node_speed, of_block, s.rigid, s.near_speed);
    return s;
}

#define TIDEWATER_INSTANTIATE(D, Real) template Simulation<D, Real> make_simulation(Start<D>);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
