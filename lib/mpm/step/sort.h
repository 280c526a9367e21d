// Sorts particles into the blocks in which they are now, when one might leave its block's margin.
//
// Before that, outlets and sponges drain their water (mpm/step/drain.h, mpm/step/skim.h), except while the
// scene settles. Afterwards the nodes with unknown fill are found anew (mpm/step/crowding.h).
//
// Tests: tests/unit/mpm/step/step_test.cpp, tests/unit/mpm/flight_test.cpp,
// tests/unit/mpm/particles/binning_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Sorts, if the motion of the step at hand, added to the drift, could pass sorting_margin.
//     node_speed         max. |v| of nodes and rigid bodies, m/s
//     grid, bodies       reads velocities and positions; a sort writes blocks and the order of particles
//     unknown_fill       as in Simulation; a sort writes it
//     drift              cells that a particle may have moved since the last sort; adds those of this step
//     skimming, outflow  accounts of the water that is drained
// Throws a NumericsError if something would move by more than sorting_margin in this step, or if a particle
// has left the tank.
template <int D, class Real>
void sort_if_needed(const Interval& interval, const Parameters<D>& parameters, double node_speed,
                    Grid<D, Real>& grid, std::vector<Particles<D, Real>>& bodies,
                    std::vector<std::uint8_t>& unknown_fill, double& drift, Skimming& skimming,
                    Outflow<D>& outflow);

}  // namespace tidewater::mpm
