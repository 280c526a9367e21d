// Sorts particles into the blocks in which they are now, when one might leave its block's margin.
//
// Each block keeps how far its fastest particle has come since the last sort, its drift, from the true motion
// of every pass. Whether the step at hand could carry one beyond the margin is asked of the nodes' speeds
// first; a node at the rim of a lone particle's stencil has almost none of its mass and may be several times
// as fast, so where the nodes say yes the block's own particles are asked.
//
// Before that, outlets and sponges drain their water (mpm/step/drain.h, mpm/step/skim.h), except while the
// scene settles. Afterwards lone water is opened (mpm/step/spray.h), and the nodes with unknown fill are
// found anew (mpm/step/crowding.h).
//
// Tests: tests/unit/mpm/step/step_test.cpp, tests/unit/mpm/flight_test.cpp,
// tests/unit/mpm/particles/binning_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Sorts, if the motion of the step at hand, added to a block's drift, would pass sorting_margin.
//     near_speed         [particle block] as in Simulation, m/s; of no use after a sort
//     grid, bodies       reads velocities and positions; a sort writes blocks, the order of particles and the
//                        volumes of lone ones
//     unknown_fill       as in Simulation; a sort writes it
//     drift              as in Simulation; a sort sets it to 0
//     skimming, outflow  accounts of the water that is drained
// Throws a NumericsError if something would move by more than sorting_margin in
// this step, or if a particle has left the tank.
template <int D, class Real>
void sort_if_needed(const Interval& interval, const Parameters<D>& parameters,
                    const std::vector<double>& near_speed, Grid<D, Real>& grid,
                    const std::vector<RigidBody>& rigid, std::vector<Particles<D, Real>>& bodies,
                    std::vector<std::uint8_t>& unknown_fill, std::vector<double>& drift, Skimming& skimming,
                    Outflow<D>& outflow);

}  // namespace tidewater::mpm
