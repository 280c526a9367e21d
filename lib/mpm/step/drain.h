// Drains the water that has passed an outlet (mpm/boundaries/outlet.h).
// Test: tests/unit/mpm/step/drain_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Done before particles are sorted.
template <int D, class Real>
void drain(const Parameters<D>& parameters, const Grid<D, Real>& grid,
           std::vector<Particles<D, Real>>& bodies, Outflow<D>& outflow);

}  // namespace tidewater::mpm
