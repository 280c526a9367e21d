// Removes water from the scene and books it, for mpm/step/drain.h and mpm/step/skim.h.
//
// Tests: tests/unit/mpm/step/drain_test.cpp, tests/unit/mpm/step/skim_test.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Removes particles from a body and adds their mass, momentum and energy to `outflow`. The nodes keep their
// mass and velocities. Blocks may be left without particles until the next sort.
//     gone  indices of the particles in the body, ascending
template <int D, class Real>
void take_out(const std::vector<std::size_t>& gone, const Parameters<D>& parameters,
              const Grid<D, Real>& grid, Particles<D, Real>& body, Outflow<D>& outflow);

}  // namespace tidewater::mpm
