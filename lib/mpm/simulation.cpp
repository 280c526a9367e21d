#include "mpm/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/hash.h"
#include "mpm/binning.h"
#include "mpm/rigid_nodes.h"
#include "mpm/transfer.h"

namespace tidewater::mpm {
namespace {

using Clock = std::chrono::steady_clock;

// Adds the time since `from` to a phase and returns now.
template <int D, class Real>
Clock::time_point charge(Simulation<D, Real>& simulation, Phase phase, Clock::time_point from) {
    const auto now = Clock::now();
    simulation.seconds[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - from).count();
    return now;
}

// The momentum gradient of a water particle, per cell: Δx m C − Δt V0 (4/Δx) τ with τ = −J p I.
template <int D, class Real>
void scatter_body(const Parameters<D>& parameters, double dx, double dt, const Particles<D, Real>& particles,
                  std::size_t slot, Node<Real>* tile) {
    const bool water = particles.material == Material::water;
    const auto mass = static_cast<Real>(particles.mass);
    const auto bulk = static_cast<Real>(parameters.water.bulk_modulus());
    const int exponent = parameters.water.exponent;
    const auto factor = static_cast<Real>(dt * particles.volume * 4.0 / dx);
    for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
        Matrix<D, Real> gradient = mass * particles.gradient[p];
        if (water) {
            const Real j = particles.j[p];
            gradient.diagonal().array() += factor * (Real(1) + j) * water_pressure(j, bulk, exponent);
        }
        scatter<D, Real>(particles.position[p], mass, mass * particles.velocity[p], gradient, tile);
    }
}

template <int D, class Real>
void scatter_all(Simulation<D, Real>& s, double dt) {
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        Node<Real>* tile = s.grid.tile(slot);
        std::fill_n(tile, Block<D>::tile_nodes, Node<Real>::Zero());
        for (const auto& particles : s.bodies) {
            scatter_body(s.parameters, s.grid.layout.cell_size, dt, particles, slot, tile);
        }
    });
}

template <int D, class Real>
void update_grid(Simulation<D, Real>& s, double dt) {
    const auto gravity_dt = static_cast<Real>(s.parameters.gravity * dt);
    parallel_for(s.grid.node_blocks.size(), [&](std::size_t slot) {
        Node<Real>* nodes = s.grid.block_nodes(slot);
        sum_tiles(s.grid, slot, nodes);
        divide_by_mass<D>(nodes);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            if (nodes[n][mass_lane] > Real(0)) nodes[n][D - 1] -= gravity_dt;
        }
    });
    std::size_t next_rigid = 0;
    for (const auto& particles : s.bodies) {
        if (particles.material == Material::rigid)
            move_nodes_as_one(particles, s.rigid[next_rigid++].center, s.grid);
    }
    std::vector<WallAction<D>> actions(s.grid.node_blocks.size());
    parallel_for(actions.size(), [&](std::size_t slot) {
        const Index<D> block = s.grid.layout.block_at(s.grid.node_blocks[slot]);
        actions[slot] =
            apply_walls<D, Real>(s.grid.layout, s.parameters.walls, block, s.grid.block_nodes(slot));
    });
    for (const auto& action : actions) {
        s.wall_impulse += action.impulse;
    }
    for (const auto& particles : s.bodies) {
        s.gravity_impulse -=
            particles.mass * static_cast<double>(particles.size()) * s.parameters.gravity * dt;
    }
}

// Extremes over a block's particles, and a sum that is zero unless a value is not finite.
struct Extremes {
    double speed2 = 0.0;  // per axis, squared, m²/s²
    double least_j = std::numeric_limits<double>::max();
    double poison = 0.0;
};

template <int D, class Real>
Extremes gather_body(double dx, double dt, Particles<D, Real>& particles, std::size_t slot,
                     const Node<Real>* tile) {
    const auto cells_per_speed = static_cast<Real>(dt / dx);
    const bool water = particles.material == Material::water;
    Real speed2 = 0, least_j = std::numeric_limits<Real>::max(), poison = 0;
    for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
        Vector<D, Real>& velocity = particles.velocity[p];
        gather<D, Real>(particles.position[p], tile, velocity, particles.gradient[p]);
        const Real square = velocity.squaredNorm();
        speed2 = std::max(speed2, square);
        poison += Real(0) * square;
        if (!water) continue;
        // J ← J (1 + Δt tr C), for j = J − 1.
        Real& j = particles.j[p];
        j += (Real(1) + j) * cells_per_speed * particles.gradient[p].trace();
        least_j = std::min(least_j, j);
        poison += Real(0) * j;
        particles.position[p] += cells_per_speed * velocity;
    }
    return {static_cast<double>(speed2), static_cast<double>(least_j), static_cast<double>(poison)};
}

template <int D, class Real>
[[noreturn]] void fail_at_bad_particle(const Simulation<D, Real>& s) {
    const std::string where =
        "step " + std::to_string(s.step) + ", t = " + std::to_string(s.time) + " s, phase gather: ";
    for (const auto& particles : s.bodies) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const bool finite = particles.velocity[p].allFinite() && particles.gradient[p].allFinite() &&
                                (particles.j.empty() || std::isfinite(particles.j[p]));
            const bool collapsed = !particles.j.empty() && !(particles.j[p] > Real(-1));
            if (finite && !collapsed) continue;
            throw NumericsError(
                where + std::string(material_name(particles.material)) + " particle " +
                std::to_string(particles.id[p]) +
                (finite ? " was squeezed to no volume" : " has a velocity that is not a number") +
                "; use a smaller simulate.cfl or a higher water.sound_speed");
        }
    }
    throw NumericsError(where + "a value is not a number");
}

template <int D, class Real>
void gather_all(Simulation<D, Real>& s, double dt) {
    std::vector<Extremes> extremes(s.grid.particle_blocks.size());
    parallel_for(extremes.size(), [&](std::size_t slot) {
        std::array<Node<Real>, static_cast<std::size_t>(Block<D>::tile_nodes)> tile;
        load_tile(s.grid, slot, tile.data());
        for (auto& particles : s.bodies) {
            const Extremes found = gather_body(s.grid.layout.cell_size, dt, particles, slot, tile.data());
            extremes[slot].speed2 = std::max(extremes[slot].speed2, found.speed2);
            extremes[slot].least_j = std::min(extremes[slot].least_j, found.least_j);
            extremes[slot].poison += found.poison;
        }
    });
    Extremes all;
    for (const Extremes& found : extremes) {
        all.speed2 = std::max(all.speed2, found.speed2);
        all.least_j = std::min(all.least_j, found.least_j);
        all.poison += found.poison;
    }
    if (all.poison != 0.0 || !(all.least_j > -1.0)) fail_at_bad_particle(s);
    s.speeds.particle = std::sqrt(all.speed2);
    if (all.least_j < std::numeric_limits<Real>::max()) {
        s.speeds.sound = s.parameters.water.sound_speed *
                         water_sound_speed_ratio(all.least_j, s.parameters.water.exponent);
    }
}

template <int D, class Real>
void move_rigid(Simulation<D, Real>& s, double dt) {
    std::size_t next = 0;
    for (auto& particles : s.bodies) {
        if (particles.material != Material::rigid) continue;
        const RigidMotion motion = move_rigid_body(s.grid, dt, s.rigid[next++], particles);
        s.speeds.particle = std::max(s.speeds.particle, motion.greatest_speed);
        for (int axis = 0; axis < D; ++axis)
            s.wall_impulse[axis] += motion.wall_impulse[axis == D - 1 ? 2 : axis];
    }
}

template <int D, class Real>
void sort_if_needed(Simulation<D, Real>& s, double dt) {
    s.drift += s.speeds.particle * dt / s.grid.layout.cell_size;
    if (s.drift <= sorting_margin) return;
    std::vector<std::vector<int>> block_of;
    for (auto& particles : s.bodies) block_of.push_back(follow(s.grid, particles));
    sort_into_blocks<D, Real>(s.grid, s.bodies, block_of);
    s.drift = 0.0;
}

}  // namespace

template <int D, class Real>
std::size_t Simulation<D, Real>::particle_count() const {
    std::size_t count = 0;
    for (const auto& particles : bodies) count += particles.size();
    return count;
}

template <int D, class Real>
double stable_time_step(const Simulation<D, Real>& s) {
    const double reach = s.parameters.cfl * s.grid.layout.cell_size;
    return std::min(reach / (s.speeds.sound + s.speeds.particle), std::sqrt(reach / s.parameters.gravity));
}

template <int D, class Real>
void advance(Simulation<D, Real>& s, double dt) {
    auto clock = Clock::now();
    scatter_all(s, dt);
    clock = charge(s, Phase::scatter, clock);
    update_grid(s, dt);
    clock = charge(s, Phase::grid, clock);
    gather_all(s, dt);
    clock = charge(s, Phase::gather, clock);
    move_rigid(s, dt);
    clock = charge(s, Phase::rigid, clock);
    sort_if_needed(s, dt);
    charge(s, Phase::sort, clock);
    s.time += dt;
    ++s.step;
}

template <int D, class Real>
std::uint64_t state_hash(const Simulation<D, Real>& s) {
    std::uint64_t hash = hash_start;
    const auto add = [&](const auto& column) { hash = hash_bytes(std::as_bytes(std::span(column)), hash); };
    for (const auto& particles : s.bodies) {
        add(particles.position);
        add(particles.velocity);
        add(particles.gradient);
        add(particles.j);
        add(particles.id);
        add(particles.begin);
    }
    return hash;
}

#define TIDEWATER_INSTANTIATE(D, Real)                            \
    template struct Simulation<D, Real>;                          \
    template double stable_time_step(const Simulation<D, Real>&); \
    template void advance(Simulation<D, Real>&, double);          \
    template std::uint64_t state_hash(const Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
