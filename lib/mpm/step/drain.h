// Drains the water that has passed an outlet (mpm/boundaries/outlet.h).
//
// Test: tests/unit/mpm/step/drain_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Call it before particles are sorted. Does nothing without an outlet.
//     grid     read for the places and velocities of the particles; the nodes stay as they are
//     bodies   lose the particles of water that have passed
//     outflow  adds their mass, momentum and energy
template <int D, class Real>
void drain(const Parameters<D>& parameters, const Grid<D, Real>& grid,
           std::vector<Particles<D, Real>>& bodies, Outflow<D>& outflow);

}  // namespace tidewater::mpm
