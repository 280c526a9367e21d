// Pressure at points, as a gauge in a wall or in the water shows it.
//
// Each node within three cells of a point x gets the volume V_i = Σ w V, the volume-weighted mean pressure
// p_i and the mean position x̄_i of the water around it (w: quadratic B-splines). p(x) is then the value p at
// x of the plane with gradient g that minimises
//
//     Σ_i W_i V_i (p_i − p − g·(x̄_i − x))²,     W_i: B-splines of twice the width around x
//
// Since each p_i is taken at its own x̄_i, a pressure that is linear in space is reproduced exactly anywhere,
// even on walls and in corners, where all water is on one side. There are three exceptions:
//
//     no water                                               0
//     water fills less than half of the nodes' volume        mean of p_i · twice the filled share, because a
//                                                            lone drop is no water column
//     it fills more, but spans too little of some axis       mean of p_i, with weights W_i V_i
//
// Test: tests/unit/mpm/readings/sensor_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The pressure (Pa) at each point (m, in the box). Sums are in the particles' order, block by block.
template <int D, class Real>
std::vector<double> pressure_at(const Simulation<D, Real>& simulation,
                                std::span<const Vector<D, double>> points);

}  // namespace tidewater::mpm
