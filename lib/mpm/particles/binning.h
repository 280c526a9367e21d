// Sorting particles into the blocks of the grid, at the start and whenever a particle may have left its block
// by more than sorting_margin. The sort is stable, so that the order of particles depends on their motion
// alone. Test: tests/unit/mpm/particles/binning_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "mpm/particles/particles.h"

namespace tidewater::mpm {

// Makes particles at the given points and sorts them into the blocks of the grid, which is still empty. Ids
// count up through all bodies. Throws NumericsError if a point lies more than a cell outside of the box, or
// if there are 2³² particles or more.
//     points      [body][particle], m
//     bodies      [body] position, id and begin are written; columns that are filled already are sorted too
template <int D, class Real>
void place(const std::vector<std::span<const Vector<D, double>>>& points, Grid<D, Real>& grid,
           std::span<Particles<D, Real>> bodies);

// Sorts particles into their present blocks; nodes keep their values. Each particle must have moved by less
// than half a cell since the last sort. Throws NumericsError, naming the particle, if one is more than a cell
// outside of the box.
template <int D, class Real>
void sort_into_blocks(Grid<D, Real>& grid, std::span<Particles<D, Real>> bodies);

}  // namespace tidewater::mpm
