// How much the drag of the ground slows each column of water in a step (mpm/boundaries/drag.h).
//
// A stage of its own, because a column's depth and the flow at its foot belong to several blocks. Scenes
// without drag skip it.
//
// Test: tests/unit/mpm/step/slow_columns_test.cpp.
#pragma once

#include "mpm/state/simulation.h"
#include "mpm/step/blocks.h"
#include "mpm/step/matter.h"

namespace tidewater::mpm {

// Δu of each column, m/s: [column][axis], columns by Columns<D>. Reads velocities that have got their forces,
// before boundaries act.
//     step   its time and dt are read
//     slots  the node blocks that count
template <int D, class Real>
std::vector<double> slow_columns(const Parameters<D>& parameters, const BoundaryStep& step,
                                 const Slots& slots, const NodeMatter<Real>& matter,
                                 const Grid<D, Real>& grid);

}  // namespace tidewater::mpm
