// The state of a run and the step that advances it.
//
// Stages of a step, in order; each is a parallel loop over blocks that write only their own data:
//     scatter   particles → tiles (P2G, with the water's pressure)
//     grid      tiles → nodes, momentum → velocity, gravity, rigid bodies' nodes, walls
//     gather    nodes → particles (G2P), J and position advance
//     rigid     each body takes over its particles' momentum and moves
//     sort      only when a particle may have left its block's margin
// Sums over blocks are taken in block order: any number of threads gives the same bits.
//
// Time step: Δt = cfl Δx / (greatest sound speed + greatest particle speed), both measured at the end of the
// last step, and at most √(cfl Δx/g), so that what starts from rest falls less than a cell in its first step.
// An isolated particle is stable for cfl < 0.71 in 2D and 0.58 in 3D (shared/physics.md §4).
#pragma once

#include <chrono>
#include <string_view>

#include "mpm/boundary.h"
#include "mpm/rigid.h"
#include "mpm/water.h"

namespace tidewater::mpm {

template <int D>
struct Parameters {
    double gravity = 9.81;  // m/s², along the last axis, downward
    double cfl = 0.5;
    WaterModel water;
    Walls<D> walls{};
};

// What the time step depends on.
struct Speeds {
    double particle = 0.0;  // greatest |v|, m/s
    double sound = 0.0;     // greatest c, m/s; 0 without water
};

enum class Phase { scatter, grid, gather, rigid, sort };
inline constexpr std::array<std::string_view, 5> phase_names{"scatter", "grid", "gather", "rigid", "sort"};

template <int D, class Real>
struct Simulation {
    Parameters<D> parameters;
    Grid<D, Real> grid;
    std::vector<Particles<D, Real>>
        bodies;                    // all particles: water first where there is any, then the rigid ones
    std::vector<RigidBody> rigid;  // of the rigid entries of bodies, in their order

    double time = 0.0;
    long step = 0;
    Speeds speeds;
    double drift = 0.0;  // cells that a particle may have moved since the last sort

    Vector<D, double> wall_impulse = Vector<D, double>::Zero();  // kg m/s that the walls gave since the start
    double gravity_impulse = 0.0;                                // along the last axis, likewise
    std::array<double, phase_names.size()> seconds{};            // wall time per Phase

    std::size_t particle_count() const;
};

// The longest stable step now, s. Infinite only without gravity, water and motion.
template <int D, class Real>
double stable_time_step(const Simulation<D, Real>& simulation);

// One step of dt. Throws NumericsError naming step, phase and particle when a value is not finite, a volume
// collapses (J ≤ 0) or a particle leaves the box.
template <int D, class Real>
void advance(Simulation<D, Real>& simulation, double dt);

// Fingerprint of positions, velocities, gradients, volumes and order of all particles.
template <int D, class Real>
std::uint64_t state_hash(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
