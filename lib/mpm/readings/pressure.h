// Pressure as it is reported.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// [body][particle, in its present order]: the pressure of the water around it, averaged over the
// grid with the particles' volumes as weights (Pa; 0 where there is no water). A particle's own pressure is
// noisy.
template <int D, class Real>
std::vector<std::vector<float>> grid_pressure(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
