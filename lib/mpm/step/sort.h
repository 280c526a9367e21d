// Sorts particles into the blocks that they are in now, when one might leave its block's margin.
//
// Before it, outlets and sponges take their water; after it, the nodes with unknown fill are found anew
// (mpm/step/crowding.h).
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The part of a simulation that sorting reads and writes.
//     drift         cells that a particle may have moved since the last sort; the coming step is added
//     unknown_fill  as Simulation has it
// Throws NumericsError if something would move by more than sorting_margin in this step, or a particle has
// left the tank.
template <int D, class Real>
void sort_if_needed(const Interval& interval, const Parameters<D>& parameters, double node_speed,
                    Grid<D, Real>& grid, std::vector<Particles<D, Real>>& bodies,
                    std::vector<std::uint8_t>& unknown_fill, double& drift, Skimming& skimming,
                    Outflow<D>& outflow);

}  // namespace tidewater::mpm
