#include "mpm/start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "mpm/binning.h"
#include "mpm/motion.h"

namespace tidewater::mpm {
namespace {

// Fills the columns that the material needs, in the order of the points. Returns the least j.
template <int D, class Real>
double fill_columns(const Start<D>& start, const typename Start<D>::Body& body,
                    Particles<D, Real>& particles) {
    double least_j = 0.0;
    if (particles.material == Material::water) {
        for (std::size_t p = 0; p < body.points.size(); ++p) {
            const double h = body.head.empty() ? body.surface - body.points[p][D - 1] : body.head[p];
            const double j = hydrostatic_j(h, start.parameters.gravity, start.parameters.water);
            particles.j.push_back(static_cast<Real>(j));
            least_j = std::min(least_j, j);
        }
    } else if (particles.material == Material::ice) {
        for (auto& column : particles.strain) column.assign(body.points.size(), Real(0));
        if (start.parameters.ice.fracture) {
            particles.alpha.assign(body.points.size(),
                                   static_cast<Real>(start.parameters.ice.initial_alpha(D)));
            particles.failure_time.assign(body.points.size(), std::numeric_limits<Real>::infinity());
        }
    }
    return least_j;
}

// The start's velocities on the nodes; ids of a body count up from first_id.
template <int D, class Real>
void scatter_start(const Start<D>& start, const std::vector<const typename Start<D>::Body*>& bodies,
                   Simulation<D, Real>& s) {
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        Node<Real>* tile = s.grid.tile(slot);
        std::fill_n(tile, Block<D>::tile_size, Node<Real>::Zero());
        std::uint32_t first_id = 0;
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
            fold<D, Real>(s.grid.layout, block_at<D>(s.grid.particle_blocks[slot]),
                          parity_of(particles.material), own.data());
            for (std::size_t n = 0; n < own.size(); ++n) tile[n] += own[n];
            first_id += static_cast<std::uint32_t>(particles.size());
        }
    });
    std::vector<double> greatest(s.grid.node_blocks.size(), 0.0);
    parallel_for(greatest.size(), [&](std::size_t slot) {
        Node<Real>* nodes = s.grid.block_nodes(slot);
        sum_tiles<D, Real>(s.grid.tiles_of_node[slot], s.grid.tiles.data(), nodes);
        momentum_to_velocity<D, Real>(Real(0), nodes);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const double speed = static_cast<double>(nodes[n].template head<D>().matrix().norm());
            if (!(speed <= greatest[slot])) greatest[slot] = speed;  // also if it is not a number
            if (!std::isfinite(speed)) return;
        }
    });
    for (const double speed : greatest) {
        if (!std::isfinite(speed)) throw NumericsError("a velocity of the start is not a number");
        s.speeds.particle = std::max(s.speeds.particle, speed);
    }
}

}  // namespace

template <int D, class Real>
Simulation<D, Real> make_simulation(const Start<D>& start) {
    Simulation<D, Real> s;
    s.parameters = start.parameters;
    s.grid.layout = Layout<D>{start.cell_size, start.cells, mirrors_of(start.parameters.boundaries)};
    std::vector<const typename Start<D>::Body*> bodies;
    std::vector<std::span<const Vector<D, double>>> points;
    double least_j = 0.0;
    for (const auto& body : start.bodies) {
        if (body.points.empty()) continue;
        bodies.push_back(&body);
        points.emplace_back(body.points);
        Particles<D, Real>& particles = s.bodies.emplace_back();
        const auto count = static_cast<double>(body.points.size());
        particles.material = body.material;
        particles.mass = body.mass / count;
        particles.volume = body.volume / count;
        least_j = std::min(least_j, fill_columns(start, body, particles));
        if (body.material == Material::rigid) {
            s.rigid.push_back(make_rigid_body(body.points, start.cell_size, particles));
        }
    }
    update_sound(s, least_j);
    place<D, Real>(points, s.grid, s.bodies);
    scatter_start(start, bodies, s);
    update_rigid(s);
    return s;
}

#define TIDEWATER_INSTANTIATE(D, Real) template Simulation<D, Real> make_simulation(const Start<D>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
