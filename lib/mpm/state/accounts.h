// What entered and left a simulation since the start. With it momentum and energy of the present state can be
// balanced against those at the start (mpm/state/ledger.h). Mass and potential energy are those until the
// state's `time`, all else until its `motion_time` (mpm/state/simulation.h).
#pragma once

#include <vector>

#include "core/types.h"

namespace tidewater::mpm {

// Water that outlet and sponge drained.
template <int D>
struct Outflow {
    double mass = 0.0;                                       // kg
    Vector<D, double> momentum = Vector<D, double>::Zero();  // kg m/s
    double kinetic = 0.0;                                    // J
    double potential = 0.0;                                  // J: gravitational and elastic
    double energy() const { return kinetic + potential; }
};

template <int D>
struct Accounts {
    Vector<D, double> wall_impulse = Vector<D, double>::Zero();  // kg m/s, of all boundaries
    double gravity_impulse = 0.0;                                // kg m/s, along the last axis
    double boundary_work = 0.0;  // J, work of moving boundaries less what the sponge's damping took
    double friction_work = 0.0;  // J ≤ 0, of ground and rigid bodies along their surfaces
    double drag_work = 0.0;      // J, of ground and rigid bodies on water
    Outflow<D> outflow;
};

// The sponge's account of the water that it still has to drain (mpm/step/skim.h).
struct Skimming {
    double time = 0.0;          // s, of the last skimming
    std::vector<double> due;    // [column] m³ to drain; empty before the first skimming
    std::vector<double> still;  // [column] m³ in still water, from the scene; filled when `due` is
};

}  // namespace tidewater::mpm
