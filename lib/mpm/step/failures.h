// The errors that stop a step: they name the step, the phase, the particle or place, and what to do.
//
// Test: tests/unit/mpm/step/step_test.cpp.
#pragma once

#include <string>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The beginning of a message: "step 12, t = 0.300000 s, phase sort: ".
std::string where(const Interval& interval, const char* phase);

// Throws a NumericsError that names the first particle whose state cannot be used.
template <int D, class Real>
[[noreturn]] void fail_at_bad_particle(const Interval& interval, const Parameters<D>& parameters,
                                       const std::vector<Particles<D, Real>>& bodies);

// Throws a NumericsError for a velocity that is not finite in node block `slot`: it names the particle that
// is the cause, if there is one, else the place of the block.
template <int D, class Real>
[[noreturn]] void fail_at_bad_node(const Interval& interval, const Parameters<D>& parameters,
                                   const Grid<D, Real>& grid, const std::vector<Particles<D, Real>>& bodies,
                                   std::size_t slot);

}  // namespace tidewater::mpm
