// The state of a run: all that a step reads and writes. mpm/step/step.h advances it.
//
// Between steps a particle keeps only its position and its strain; velocities are on the grid. Positions and
// strains are those of `time`, while velocities, and with them the accounts, are those of the middle of the
// following step, `motion_time` = time + dt/2 (leapfrog). A simulation starts with dt = 0 and the initial
// velocities.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "mpm/base/interval.h"
#include "mpm/bodies/rigid.h"
#include "mpm/boundaries/boundaries.h"
#include "mpm/materials/ice.h"
#include "mpm/materials/water.h"
#include "mpm/particles/particles.h"
#include "mpm/particles/transfer.h"
#include "mpm/state/accounts.h"

namespace tidewater::mpm {

// What never changes during a run.
template <int D>
struct Parameters {
    double gravity = 9.81;  // m/s², along the last axis, downward
    double cfl = 0.5;       // lib/mpm/README.md, Time step
    WaterModel water;
    IceModel ice;
    Boundaries<D> boundaries;
    Transfer transfer = Transfer::apic;
};

// The settle phase before time begins (mpm/step/settle.h).
struct Settling {
    bool going = false;   // ice does not fail, and boundaries stay as at time 0
    double stress = 0.0;  // Pa, of the waves at the last peak of kinetic energy
    double energy = 0.0;  // J, max. kinetic energy since everything was last stopped
    long quiet = 0;       // consecutive peaks whose stress was within the tolerance
    double time = 0.0;    // s, since settling began
};

// How fast something crosses the cells of a block: c + v of its material, or of a rigid body.
struct Signal {
    double sound = 0.0;                   // c, m/s
    double motion = 0.0;                  // v, m/s
    Material material = Material::water;  // whose c it is

    double speed() const { return sound + motion; }
};

// The speeds that limit the time step.
struct Speeds {
    double particle = 0.0;  // m/s, max. |v| of nodes and rigid bodies
    double sound = 0.0;     // m/s, max. c of all materials; 0 without water and ice
    Signal signal;          // that of the fastest block (mpm/step/time_step.h)
};

// The parts of a step whose wall time is measured.
enum class Phase { sort, pass, grid, rigid };
inline constexpr std::array<std::string_view, 4> phase_names{"sort", "pass", "grid", "rigid"};
using PhaseSeconds = std::array<double, phase_names.size()>;

template <int D, class Real>
struct Simulation {
    Parameters<D> parameters;
    Grid<D, Real> grid;
    std::vector<Particles<D, Real>> bodies;
    std::vector<RigidBody> rigid;

    double time = 0.0;  // s
    double dt = 0.0;    // s, of the following step
    long step = 0;      // number of steps so far
    Speeds speeds;
    // [particle block] m/s, max. |v| of the nodes that its particles may feel; and cells, the longest way
    // along an axis that one of them has moved since the last sort (mpm/step/sort.h).
    std::vector<double> near_speed, drift;
    // [node block][node], not 0 where the filled share is unknown; empty if it is known everywhere
    // (mpm/step/crowding.h).
    std::vector<std::uint8_t> unknown_fill;

    Accounts<D> accounts;
    Skimming skimming;
    Settling settling;
    PhaseSeconds seconds{};  // wall time of each Phase

    double motion_time() const { return time + 0.5 * dt; }  // s, of the velocities and the accounts
    std::size_t particle_count() const;
    Interval interval(double next_dt) const {
        return {.step = step, .begin = time, .dt = dt, .next_dt = next_dt, .settling = settling.going};
    }
};

// A hash of all particles, in their order, and of all nodes.
template <int D, class Real>
std::uint64_t state_hash(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
