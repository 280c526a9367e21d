// The nodes' part of a step: tiles → nodes, momentum → velocity, gravity, boundaries.
//
// The first two stages work on one block of nodes each, so that the driver may call them one after the other
// while the block is in the cache (mpm/step/step.cpp).
#pragma once

#include "mpm/boundaries/boundaries.h"
#include "mpm/state/simulation.h"
#include "mpm/step/blocks.h"

namespace tidewater::mpm {

// Sums the tiles that reach node block `slot` and turns momenta into velocities, to which `kick` (m/s) is
// added along the last axis. It asks the grid alone which tiles there are, not who filled them: particles of
// this process, or those of a neighbour whose tiles were copied here.
template <int D, class Real>
void sum_momenta(Real kick, std::size_t slot, Grid<D, Real>& grid);

// What the boundaries did to a block of nodes, and max. |v|² afterwards, m²/s²; NaN if one is not finite.
template <int D>
struct NodeResult {
    WallAction<D> action;
    double max_speed2 = 0.0;
};

template <int D, class Real>
NodeResult<D> bound_velocities(const ActingBoundaries<D>& acting, std::size_t slot, Grid<D, Real>& grid);

// Adds what walls that mirror give to the particles when these read the nodes' velocities next; uses up the
// masses that folding kept in the tiles.
template <int D, class Real>
void add_unfolding_impulse(const Slots& particle_slots, Grid<D, Real>& grid, Vector<D, double>& wall_impulse);

}  // namespace tidewater::mpm
