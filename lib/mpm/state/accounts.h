// What came into a simulation and left it since the start, so that momentum and energy can be balanced
// against what is there (mpm/state/ledger.h).
#pragma once

#include <vector>

#include "core/types.h"

namespace tidewater::mpm {

// Water that left through an outlet or a sponge.
template <int D>
struct Outflow {
    double mass = 0.0;                                       // kg
    Vector<D, double> momentum = Vector<D, double>::Zero();  // kg m/s
    double energy = 0.0;                                     // J, kinetic, gravitational and elastic
};

template <int D>
struct Accounts {
    Vector<D, double> wall_impulse = Vector<D, double>::Zero();  // kg m/s that boundaries gave
    double gravity_impulse = 0.0;                                // kg m/s along the last axis
    double boundary_work = 0.0;  // J that moving boundaries did, less what sponges took
    Outflow<D> outflow;
};

// The sponge's account of the water that it still has to take (mpm/step/skim.h).
struct Skimming {
    double time = 0.0;          // s, when it last took water
    std::vector<double> due;    // [column] m³; empty until it takes for the first time
    std::vector<double> still;  // [column] m³ in still water; follows from the scene, filled with `due`
};

}  // namespace tidewater::mpm
