// The pressure that frames report.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The pressure (Pa) of the water around each particle, [body][particle in its present order]; 0 where there
// is no water. It is averaged over the grid with the particles' volumes as weights, because the pressure of a
// single particle is noisy.
template <int D, class Real>
std::vector<std::vector<float>> grid_pressure(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
