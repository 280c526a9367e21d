// The nodes' part of a step: tiles → nodes, momentum → velocity, gravity, boundaries.
//
// sum_momenta and bound_velocities work on one block of nodes each, so that the driver may call one after the
// other while the block is in the cache (mpm/step/step.cpp).
//
// Tests: tests/unit/mpm/step/blocks_test.cpp, tests/unit/mpm/twin_test.cpp.
#pragma once

#include "mpm/boundaries/boundaries.h"
#include "mpm/state/simulation.h"
#include "mpm/step/blocks.h"
#include "mpm/step/matter.h"

namespace tidewater::mpm {

// Sums the tiles that reach node block `slot`, turns momenta into velocities and adds `kick` (m/s), the
// change by gravity, along the last axis. Reads the grid's tiles and writes the block's nodes. Which tiles
// there are is known from the grid alone, so they may come from particles of this process or be copies of a
// neighbour's.
template <int D, class Real>
void sum_momenta(Real kick, std::size_t slot, Grid<D, Real>& grid);

// What bound_velocities found in a block of nodes.
template <int D>
struct NodeResult {
    WallAction<D> action;     // what the boundaries did
    double max_speed2 = 0.0;  // max. |v|² afterwards, m²/s²; NaN if a velocity is not finite
};

// Applies the boundaries to the velocities of node block `slot`.
//     grip  [node block][node] as NodeAt has it; empty where a step meets its boundaries once
template <int D, class Real>
NodeResult<D> bound_velocities(const ActingBoundaries<D>& acting, const NodeMatter<Real>& matter,
                               std::size_t slot, std::span<float> grip, Grid<D, Real>& grid);

// Adds to wall_impulse (kg m/s) what walls that mirror will give to the particles when these next read the
// nodes' velocities. Reads these velocities, and reads and clears the masses that folding kept in the tiles.
//     particle_slots  the blocks whose tiles are unfolded
template <int D, class Real>
void add_unfolding_impulse(const Slots& particle_slots, Grid<D, Real>& grid, Vector<D, double>& wall_impulse);

}  // namespace tidewater::mpm
