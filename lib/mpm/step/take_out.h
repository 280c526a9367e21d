// Takes water out of the scene and books it. Who does so: mpm/step/drain.h, mpm/step/skim.h.
#pragma once

#include <cstddef>
#include <vector>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Removes these particles of a body (places in it, ascending) and adds them to `outflow`. The nodes keep
// their velocities; blocks may stay without particles until they are sorted.
template <int D, class Real>
void take_out(const std::vector<std::size_t>& gone, const Parameters<D>& parameters,
              const Grid<D, Real>& grid, Particles<D, Real>& body, Outflow<D>& outflow);

}  // namespace tidewater::mpm
