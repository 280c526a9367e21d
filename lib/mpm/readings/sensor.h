// Pressure at points, as a gauge in a wall or in the water shows it.
//
// The nodes within three cells of a point x get the volume V_i = Σ w V, the volume-weighted mean pressure p_i
// and the mean place x̄_i of the water around them (w: quadratic B-splines). Then p(x) is the value at x of
// the plane
//
//     min Σ_i W_i V_i (p_i − p − g·(x̄_i − x))²,     W_i: B-splines of twice the width around x
//
// Since each p_i is told of its own x̄_i, a pressure that is linear in space comes out exactly anywhere, on
// walls and in corners too, where all water is on one side. Where that water does not span all axes, or fills
// less than half of what it could, the weighted mean of p_i is taken, times twice the filled share: a lone
// drop is no water column. 0 where there is no water. Test: tests/unit/mpm/readings/sensor_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Pa at each point (m, in the box). Sums in the particles' order, block by block.
template <int D, class Real>
std::vector<double> pressure_at(const Simulation<D, Real>& simulation,
                                std::span<const Vector<D, double>> points);

}  // namespace tidewater::mpm
