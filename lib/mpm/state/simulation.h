// The state of a run: all that a step reads and writes. What advances it is mpm/step/step.h.
//
// Between steps a particle keeps its place and its strain only; velocities are on the grid. At `time` the
// positions and strains are those of that time, and the velocities already have the forces of the step `dt`
// that follows (symplectic Euler: first all velocities, then all positions). A simulation starts with dt = 0
// and the velocities of its start.
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

// What stays as it is through a run.
template <int D>
struct Parameters {
    double gravity = 9.81;  // m/s², along the last axis, downward
    double cfl = 0.5;
    WaterModel water;
    IceModel ice;
    Boundaries<D> boundaries;
    Transfer transfer = Transfer::apic;
};

// The settle phase before time begins (mpm/step/settle.h).
struct Settling {
    bool going = false;   // ice does not fail, and the boundaries are those of time 0
    double stress = 0.0;  // of the waves at the last peak of kinetic energy, Pa
    double energy = 0.0;  // max. kinetic energy since the last stop, J
    long quiet = 0;       // peaks in a row that were low enough
    double time = 0.0;    // s, spent in it
};

// What the time step depends on.
struct Speeds {
    double particle = 0.0;  // max. |v| of the nodes, or of the rigid bodies where that is more, m/s
    double sound = 0.0;     // max. c of all materials, m/s; 0 without water and ice
};

// The parts of a step whose wall time is told.
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
    double dt = 0.0;    // of the step that comes, whose forces the velocities have already, s
    long step = 0;
    Speeds speeds;
    double drift = 0.0;  // cells that a particle may have moved since the last sort
    std::vector<std::uint8_t>
        unknown_fill;  // [node block][node] not 0: mpm/step/crowding.h; empty if there is none

    Accounts<D> accounts;
    Skimming skimming;
    Settling settling;
    PhaseSeconds seconds{};  // wall time per Phase

    std::size_t particle_count() const;
    Interval interval(double next_dt) const {
        return {.step = step, .begin = time, .dt = dt, .next_dt = next_dt, .settling = settling.going};
    }
};

// Fingerprint of all particles, in their order, and all nodes.
template <int D, class Real>
std::uint64_t state_hash(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
