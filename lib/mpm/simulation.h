// The state of a run and the step that advances it.
//
// Between steps a particle keeps its place and its strain only; velocities are on the grid. advance(s, next)
// is one step, in these stages; each is a parallel loop over blocks that write only their own data:
//     sort        only when a particle might leave its block's margin; before it outlet and sponge take water
//     pass        nodes → particles (G2P), strain and position advance by s.dt, then particles → tiles (P2G)
//                 with the forces of the coming step `next`: all while a batch of particles is in the cache
//     grid        tiles → nodes, momentum → velocity, gravity, walls
//     rigid       before the walls: rigid bodies meet their nodes, walls and each other (mpm/contact.h)
// Sums over blocks are taken in block order: any number of threads gives the same bits.
//
// So at s.time the positions and strains are those of that time, and the velocities already have the forces
// of the step s.dt that follows (symplectic Euler: first all velocities, then all positions). A simulation
// starts with s.dt = 0 and the velocities of its start.
//
// Time step: Δt = cfl Δx / (greatest sound speed + greatest speed of a node), and at most so that what moves
// and falls moves 0.4 cells. An isolated particle is stable for cfl < 0.71 in 2D and 0.58 in 3D
// (lib/mpm/README.md, Time step). Forces may make something faster within that step: advance refuses only
// what would carry a particle beyond sorting_margin or turn its volume inside out (greatest_motion in
// mpm/motion.h).
#pragma once

#include <array>
#include <string_view>

#include "mpm/boundary.h"
#include "mpm/ice.h"
#include "mpm/outlet.h"
#include "mpm/rigid.h"
#include "mpm/skim.h"
#include "mpm/water.h"

namespace tidewater::mpm {

// How velocities go from the nodes to the particles and back: by APIC, or by APIC with what that loses given
// back (mpm/restore.h).
enum class Transfer { apic, restored };

template <int D>
struct Parameters {
    double gravity = 9.81;  // m/s², along the last axis, downward
    double cfl = 0.5;
    WaterModel water;
    IceModel ice;
    Boundaries<D> boundaries;
    Outlet outlet;
    Transfer transfer = Transfer::apic;
};

// The settle phase before time begins (mpm/settle.h).
struct Settling {
    long going = 0;       // ice does not fail, and the boundaries are those of time 0
    double stress = 0.0;  // of the waves at the last peak of kinetic energy, Pa
    double energy = 0.0;  // greatest kinetic energy since the last stop, J
    long quiet = 0;       // peaks in a row that were low enough
    double time = 0.0;    // s, spent in it
};

// What the time step depends on.
struct Speeds {
    double particle = 0.0;  // the greatest |v| of a node, or of a rigid body where that is more, m/s
    double sound = 0.0;     // greatest c, m/s; 0 without water and ice
};

enum class Phase { sort, pass, grid, rigid };
inline constexpr std::array<std::string_view, 4> phase_names{"sort", "pass", "grid", "rigid"};

template <int D, class Real>
struct Simulation {
    Parameters<D> parameters;
    Grid<D, Real> grid;
    std::vector<Particles<D, Real>> bodies;
    std::vector<RigidBody> rigid;

    double time = 0.0;  // s
    double dt = 0.0;    // of the step that comes, whose forces the velocities have already, s
    long step = 0;
    Speeds speeds;
    double drift = 0.0;  // cells that a particle may have moved since the last sort
    std::vector<std::uint8_t>
        unknown_fill;  // [node block][node], not 0: mpm/crowding.h; empty if there is none

    Vector<D, double> wall_impulse = Vector<D, double>::Zero();  // kg m/s that the walls gave since the start
    double gravity_impulse = 0.0;                                // along the last axis, likewise
    double boundary_work = 0.0;  // J by what moves since the start, less what sponges took
    Outflow<D> outflow;          // what left through the outlet and the sponge
    Skimming skimming;
    Settling settling;
    std::array<double, phase_names.size()> seconds{};  // wall time per Phase

    std::size_t particle_count() const;
};

// The longest stable step now, s. Infinite only without gravity, sound and motion.
template <int D, class Real>
double stable_time_step(const Simulation<D, Real>& simulation);

// Advances by s.dt and gives the velocities the forces of a step of next_dt, which becomes s.dt. Throws
// NumericsError naming step, phase and particle when a value is not finite, a volume collapses (J ≤ 0), a
// particle leaves the box or moves half a cell in one step, its affine motion counted.
template <int D, class Real>
void advance(Simulation<D, Real>& simulation, double next_dt);

// The greatest sound speed, with least_j ≤ 0 the least j of the water.
template <int D, class Real>
void update_sound(Simulation<D, Real>& simulation, double least_j);

// Fingerprint of all particles, in their order, and all nodes.
template <int D, class Real>
std::uint64_t state_hash(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
