// What a step says when it cannot go on: which step, which phase, which particle or place, and what to do.
#pragma once

#include <string>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// "step 12, t = 0.3 s, phase sort: "
std::string where(const Interval& interval, const char* phase);

// Throw NumericsError that names a particle whose state cannot be used, or the place of a node block where a
// velocity is not finite.
template <int D, class Real>
[[noreturn]] void fail_at_bad_particle(const Interval& interval, const Parameters<D>& parameters,
                                       const std::vector<Particles<D, Real>>& bodies);
template <int D, class Real>
[[noreturn]] void fail_at_bad_node(const Interval& interval, const Parameters<D>& parameters,
                                   const Grid<D, Real>& grid, const std::vector<Particles<D, Real>>& bodies,
                                   std::size_t slot);

}  // namespace tidewater::mpm
