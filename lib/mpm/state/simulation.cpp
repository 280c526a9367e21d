#include "mpm/state/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/hash.h"
#include "mpm/particles/binning.h"
#include "mpm/step/contact.h"
#include "mpm/step/crowding.h"
#include "mpm/particles/motion.h"
#include "mpm/step/particle_pass.h"
#include "mpm/step/restore.h"

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

template <int D, class Real>
std::string where(const Simulation<D, Real>& s, const char* phase) {
    return "step " + std::to_string(s.step) + ", t = " + std::to_string(s.time) + " s, phase " + phase + ": ";
}

// By how many cells things may move in a step when they do at this speed.
template <int D, class Real>
double cells_moved(const Simulation<D, Real>& s, double speed) {
    return speed * s.dt / s.grid.layout.cell_size;
}

// A bound of the speed of all particles, m/s: the nodes' and, only where that is too much for the step, the
// particles' own. A node at the edge of what a lone particle reaches has almost none of its mass, and may be
// several times as fast.
template <int D, class Real>
double fastest(const Simulation<D, Real>& s) {
    if (cells_moved(s, s.speeds.particle) <= sorting_margin) return s.speeds.particle;
    double most = 0.0;
    for (const auto& particles : s.bodies) most = std::max(most, greatest_motion(s.grid, particles));
    return most;
}

template <int D, class Real>
void sort_if_needed(Simulation<D, Real>& s) {
    const double speed = fastest(s), cells = cells_moved(s, speed);
    if (cells > sorting_margin) {
        throw NumericsError(where(s, "sort") + "something moves by " + std::to_string(cells) +
                            " cells in one step, at " + std::to_string(speed) +
                            " m/s; use a smaller simulate.cfl");
    }
    if (s.drift + cells > sorting_margin) {
        if (!s.settling.going) {
            if (s.parameters.outlet.exists()) drain(s);
            skim(s);
        }
        sort_into_blocks<D, Real>(s.grid, s.bodies);
        mark_unknown_fill(s);
        s.drift = 0.0;
    }
    s.drift += cells;
}

// Whether ice_stress finds the particle unusable.
template <int D, class Real>
bool beyond_elastic_ice(const Particles<D, Real>& particles, std::size_t p) {
    constexpr int count = symmetric_size<D>;
    Column<Real> strain[count]{}, stress[count];
    for (std::size_t c = 0; c < count; ++c) strain[c][0] = particles.strain[c][p];
    return ice_stress<D, Real>(IceConstants<D, Real>(IceModel{}), strain, lanes, stress) & ice_unusable;
}

// What is wrong with a particle; null if nothing is.
template <int D, class Real>
const char* complaint(const Particles<D, Real>& particles, std::size_t p, bool fracture) {
    bool finite = particles.j.empty() || std::isfinite(particles.j[p]);
    for (const auto& column : particles.strain)
        finite = finite && (column.empty() || std::isfinite(column[p]));
    if (!finite) return " has a strain that is not a number; use a smaller simulate.cfl";
    if (particles.material == Material::water && particles.j[p] <= Real(-1))
        return " was squeezed to no volume; use a smaller simulate.cfl or a higher water.sound_speed";
    if (particles.material == Material::ice && !fracture && beyond_elastic_ice(particles, p))
        return " is strained beyond what elastic ice can bear, as ice is without the effect \"fracture\" and "
               "while it settles; lower its load or use a smaller simulate.cfl";
    return nullptr;
}

// Names a particle whose state cannot be used; empty if there is none.
template <int D, class Real>
std::string bad_particle(const Simulation<D, Real>& s) {
    const bool fracture = s.parameters.ice.fracture && s.settling.going == 0;
    for (const auto& particles : s.bodies) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const char* what = complaint(particles, p, fracture);
            if (what == nullptr) continue;
            return std::string(material_name(particles.material)) + " particle " +
                   std::to_string(particles.id[p]) + what;
        }
    }
    return {};
}

template <int D, class Real>
[[noreturn]] void fail_at_bad_particle(const Simulation<D, Real>& s) {
    throw NumericsError(where(s, "pass") + bad_particle(s));
}

template <int D, class Real>
void move_particles(Simulation<D, Real>& s, double next_dt) {
    const PassContext<D, Real> context(s, next_dt);
    std::vector<PassResult<D>> results(s.grid.particle_blocks.size());
    parallel_for(results.size(), [&](std::size_t slot) {
        alignas(64) Tile<D, Real> tile;
        load_velocities(s.grid, slot, tile.data());
        if (context.crowding_rate > Real(0) && has_water(s, slot)) load_crowding(s, slot, tile.data());
        results[slot] = pass_over_block(context, slot, tile.data(), s);
    });
    PassResult<D> all;
    for (const PassResult<D>& result : results) {
        all.least_j = std::min(all.least_j, result.least_j);
        all.unusable = all.unusable || result.unusable;
        s.wall_impulse += result.impulse;
    }
    if (all.unusable || !(all.least_j > -1.0)) fail_at_bad_particle(s);
    update_sound(s, all.least_j);
    if (s.settling.going) return;
    for (RigidBody& body : s.rigid) move_rigid_body(s.dt, body);  // the pass knew where they were
}

// The greatest |v|² of a block's nodes; NaN if a velocity is not finite.
template <int D, class Real>
double greatest_speed2(const Node<Real>* nodes) {
    Column<Real> greatest{}, poison{};
    for (int first = 0; first < Block<D>::nodes; first += batch_size) {
        for (int n = 0; n < batch_size; ++n) {
            const Real* node = nodes[first + n].data();
            Real speed2 = node[0] * node[0] + node[1] * node[1];
            if constexpr (D == 3) speed2 += node[2] * node[2];
            greatest[n] = std::max(greatest[n], speed2);
            poison[n] += Real(0) * speed2;
        }
    }
    double most = 0.0;
    for (int n = 0; n < batch_size; ++n) most = std::max(most, static_cast<double>(greatest[n]));
    for (int n = 0; n < batch_size; ++n) most += static_cast<double>(poison[n]);
    return most;
}

template <int D, class Real>
[[noreturn]] void fail_at_bad_node(const Simulation<D, Real>& s, std::size_t slot) {
    if (const std::string what = bad_particle(s); !what.empty()) {
        throw NumericsError(where(s, "pass") + what);
    }
    const Index<D> block = block_at<D>(s.grid.node_blocks[slot]);
    std::string place;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const double middle = s.grid.layout.first_node(block[axis]) + 0.5 * Block<D>::width;
        place += (axis > 0 ? ", " : "") + std::to_string(s.grid.layout.cell_size * middle);
    }
    throw NumericsError(where(s, "grid") + "a velocity near (" + place +
                        ") m is not a number; use a smaller simulate.cfl");
}

// What walls that mirror give to the particles when these read the nodes' velocities next.
template <int D, class Real>
void add_unfolding_impulse(Simulation<D, Real>& s) {
    std::vector<Vector<D, double>> of_block(s.grid.particle_blocks.size(), Vector<D, double>::Zero());
    parallel_for(of_block.size(), [&](std::size_t slot) {
        const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
        if (!has_mirror<D>(s.grid.layout, block)) return;
        Tile<D, Real> tile;
        load_velocities(s.grid, slot, tile.data());
        of_block[slot] = unfolding_impulse<D, Real>(s.grid.layout, block, tile.data(), s.grid.tile(slot));
    });
    for (const auto& impulse : of_block) s.wall_impulse += impulse;
}

template <int D, class Real>
void update_grid(Simulation<D, Real>& s, double next_dt) {
    auto began = Clock::now();
    const auto kick = static_cast<Real>(-s.parameters.gravity * next_dt);
    std::vector<WallAction<D>> actions(s.grid.node_blocks.size());
    std::vector<double> speed2(actions.size());
    const double time = s.settling.going ? -1.0 : s.time + s.dt;  // before any push
    const Layout<D>& layout = s.grid.layout;
    const Boundaries<D>& boundaries = s.parameters.boundaries;
    const MovingPlane piston = plane_at(layout.cell_size, boundaries.piston, time);
    const auto finish = [&](std::size_t slot, double dt) {
        Node<Real>* nodes = s.grid.block_nodes(slot);
        const Index<D> block = block_at<D>(s.grid.node_blocks[slot]);
        // The bed first: after the bottom wall it would turn what presses on a slope into motion along it.
        actions[slot] = apply_bed<D, Real>(layout, boundaries.bed, block, nodes);
        actions[slot].add(apply_boundaries<D, Real>(layout, boundaries, time, block, nodes));
        actions[slot].add(apply_plane<D, Real>(layout, piston, block, nodes));
        actions[slot].add(apply_sponge<D, Real>(layout, boundaries.sponge, dt, block, nodes));
        speed2[slot] = greatest_speed2<D, Real>(nodes);
    };
    const bool plain = s.rigid.empty();
    parallel_for(actions.size(), [&](std::size_t slot) {
        Node<Real>* nodes = s.grid.block_nodes(slot);
        sum_tiles<D, Real>(s.grid.tiles_of_node[slot], s.grid.tiles.data(), nodes);
        momentum_to_velocity<D, Real>(kick, nodes);
        if (plain) finish(slot, next_dt);
    });
    if (!plain) {
        const auto clock = charge(s, Phase::grid, began);
        meet_bodies(next_dt, next_dt, s);
        began = charge(s, Phase::rigid, clock);
        parallel_for(actions.size(), [&](std::size_t slot) { finish(slot, next_dt); });
    }
    double greatest = 0.0;
    const auto take_actions = [&] {
        greatest = 0.0;
        for (std::size_t slot = 0; slot < actions.size(); ++slot) {
            if (!std::isfinite(speed2[slot])) fail_at_bad_node(s, slot);
            greatest = std::max(greatest, speed2[slot]);
            s.wall_impulse += actions[slot].impulse;
            s.boundary_work += actions[slot].work;
        }
    };
    take_actions();
    if (s.parameters.transfer == Transfer::restored) {
        restore_velocities(s);
        meet_bodies(next_dt, 0.0, s);
        parallel_for(actions.size(), [&](std::size_t slot) { finish(slot, 0.0); });
        take_actions();
    }
    s.speeds.particle = std::sqrt(greatest);
    add_unfolding_impulse(s);
    for (const auto& particles : s.bodies) {
        s.gravity_impulse -=
            particles.mass * static_cast<double>(particles.size()) * s.parameters.gravity * next_dt;
    }
    for (const RigidBody& body : s.rigid) {
        s.gravity_impulse -= body.mass * s.parameters.gravity * next_dt;
        s.speeds.particle = std::max(s.speeds.particle, greatest_speed(body));
    }
    charge(s, Phase::grid, began);
}

}  // namespace

template <int D, class Real>
std::size_t Simulation<D, Real>::particle_count() const {
    std::size_t count = 0;
    for (const auto& particles : bodies) count += particles.size();
    return count;
}

template <int D, class Real>
void update_sound(Simulation<D, Real>& s, double least_j) {
    s.speeds.sound = 0.0;
    for (const auto& particles : s.bodies) {
        double speed = 0.0;
        if (particles.material == Material::water) {
            speed = s.parameters.water.sound_speed *
                    water_sound_speed_ratio(least_j, s.parameters.water.exponent);
        } else if (particles.material == Material::ice) {
            speed = s.parameters.ice.wave_speed(D);
        }
        s.speeds.sound = std::max(s.speeds.sound, speed);
    }
}

template <int D, class Real>
double stable_time_step(const Simulation<D, Real>& s) {
    const double dx = s.grid.layout.cell_size, v = s.speeds.particle;
    const double g = s.parameters.gravity;
    // v Δt + g Δt² ≤ 0.4 Δx, solved without cancellation; leaves room within the sorting margin.
    const double reach = 0.4 * dx;
    const double falling = 2.0 * reach / (v + std::sqrt(v * v + 4.0 * g * reach));
    return std::min(s.parameters.cfl * dx / (s.speeds.sound + v), falling);
}

template <int D, class Real>
void advance(Simulation<D, Real>& s, double next_dt) {
    auto clock = Clock::now();
    sort_if_needed(s);
    clock = charge(s, Phase::sort, clock);
    move_particles(s, next_dt);
    charge(s, Phase::pass, clock);
    update_grid(s, next_dt);
    s.time += s.dt;
    s.dt = next_dt;
    ++s.step;
}

template <int D, class Real>
std::uint64_t state_hash(const Simulation<D, Real>& s) {
    std::uint64_t hash = hash_start;
    const auto add = [&](const auto& column) { hash = hash_bytes(std::as_bytes(std::span(column)), hash); };
    for (const auto& particles : s.bodies) {
        for_each_column(particles, [&](const std::string&, const auto& column) { add(column); });
        add(particles.begin);
    }
    add(s.grid.nodes);
    return hash;
}

#define TIDEWATER_INSTANTIATE(D, Real)                            \
    template struct Simulation<D, Real>;                          \
    template double stable_time_step(const Simulation<D, Real>&); \
    template void advance(Simulation<D, Real>&, double);          \
    template void update_sound(Simulation<D, Real>&, double);     \
    template std::uint64_t state_hash(const Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
