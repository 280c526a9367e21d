// Sorting particles into the blocks of the grid. Needed at the start and whenever a particle may have left
// its block by more than sorting_margin; stable, so that the order of particles depends on their motion
// alone.
#pragma once

#include <span>
#include <vector>

#include "mpm/particles.h"

namespace tidewater::mpm {

// Fills the columns position, velocity (zero), gradient (zero) and id with particles at these points (m), ids
// counting up from first_id, and returns the block index of each.
// Throws NumericsError if a point lies outside of the box.
template <int D, class Real>
std::vector<int> place(const Layout<D>& layout, const std::vector<Vector<D, double>>& points,
                       std::uint32_t first_id, Particles<D, Real>& particles);

// Moves every particle's position into the frame of the block that it is in now, and returns each one's block
// index. Throws NumericsError naming the particle if one is more than a cell beyond a wall, or nowhere (NaN).
template <int D, class Real>
std::vector<int> follow(const Grid<D, Real>& grid, Particles<D, Real>& particles);

// Activates the blocks that hold particles of any body and sorts each body's columns by block.
//     block_of   [body][particle] the block index, as place or follow returned it
template <int D, class Real>
void sort_into_blocks(Grid<D, Real>& grid, std::span<Particles<D, Real>> bodies,
                      const std::vector<std::vector<int>>& block_of);

}  // namespace tidewater::mpm
