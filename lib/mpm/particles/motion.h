// Velocities of particles, read from the grid.
//
// Between steps only nodes have velocities (mpm/state/simulation.h). A particle's velocity v_p = Σ w u and
// gradient Δx C = 4 Σ w u (x_i − x_p)ᵀ/Δx are those that the next step will gather.
#pragma once

#include <algorithm>
#include <cmath>

#include "mpm/grid/mirror.h"
#include "mpm/particles/particles.h"
#include "mpm/particles/transfer.h"

namespace tidewater::mpm {

// The nodes around one particle block.
template <int D, class Real>
using Tile = std::array<Node<Real>, static_cast<std::size_t>(Block<D>::tile_size)>;

// of ← max(of, |column|), particle by particle.
template <class Real>
void take_max_size(const Column<Real>& column, Column<Real>& of) {
    for (int p = 0; p < batch_size; ++p) of[p] = std::max(of[p], std::abs(column[p]));
}

// The fastest of the particles of one block. By Bessel's inequality (1 and 2 (x_i − x_p)/Δx are orthonormal
// under the weights) √(|v|² + ¼ |Δx C|²) is at most √(Σ w |v_i|²). So it never exceeds the speed of the
// fastest node, and it is far smaller where that node has only a tiny share of a particle's mass. While it is
// below Δx/(2Δt), no particle moves half a cell, and |Δt C| < 1, so that no volume is turned inside out.
struct BlockMotion {
    double along = 0.0;  // m/s, max. |v| along an axis
    double all = 0.0;    // m/s, max. √(|v|² + ¼ |Δx C|²)
};
template <int D, class Real>
BlockMotion motion_of_block(const Grid<D, Real>& grid, const std::vector<Particles<D, Real>>& bodies,
                            std::size_t slot);

// Calls visit(block slot, block, particle, velocity (m/s), velocity gradient Δx C (m/s)) for all particles.
// Blocks are visited in parallel, the particles of each block in order.
template <int D, class Real, class Visit>
void for_each_motion(const Grid<D, Real>& grid, const Particles<D, Real>& particles, const Visit& visit) {
    parallel_for(grid.particle_blocks.size(), [&](std::size_t slot) {
        if (particles.begin[slot] == particles.begin[slot + 1]) return;
        const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
        Tile<D, Real> tile;
        load_velocities(grid, slot, tile.data());
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            Vector<D, Real> velocity;
            Matrix<D, Real> gradient;
            gather<D, Real>(local_position<D, Real>(particles, p), tile.data(), velocity, gradient);
            visit(slot, block, p, velocity, gradient);
        }
    });
}

}  // namespace tidewater::mpm
