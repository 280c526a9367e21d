// Sorting particles into the blocks of the grid. Needed at the start and whenever a particle may have left
// its block by more than sorting_margin; stable, so that the order of particles depends on their motion
// alone. Test: tests/unit/mpm/particles/binning_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "mpm/particles/particles.h"

namespace tidewater::mpm {

// Makes particles at these points (m) and sorts them into the blocks of the grid, which holds nothing yet.
//     points      [body][particle]
//     bodies      [body] position, id and begin are written; columns that are filled already are sorted along
// Ids count up through all bodies. Throws NumericsError if a point lies more than a cell
// outside of the box.
template <int D, class Real>
void place(const std::vector<std::span<const Vector<D, double>>>& points, Grid<D, Real>& grid,
           std::span<Particles<D, Real>> bodies);

// Sorts particles that moved by less than half a cell since they were sorted into the blocks that they are in
// now; nodes keep their values. Throws NumericsError naming the particle if one is more than a cell beyond a
// wall.
template <int D, class Real>
void sort_into_blocks(Grid<D, Real>& grid, std::span<Particles<D, Real>> bodies);

}  // namespace tidewater::mpm
