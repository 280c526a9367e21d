// Velocities of particles, read from the grid.
//
// Between steps velocities live on the nodes alone (mpm/simulation.h); a particle's are v_p = Σ w u and
// Δx C = 4 Σ w u (x_i − x_p)ᵀ/Δx, as the next step will read them.
#pragma once

#include "mpm/mirror.h"
#include "mpm/particles.h"
#include "mpm/transfer.h"

namespace tidewater::mpm {

template <int D, class Real>
using Tile = std::array<Node<Real>, static_cast<std::size_t>(Block<D>::tile_size)>;

// How walls mirror a body's share of the nodes.
inline Parity parity_of(Material material) {
    return material == Material::rigid ? Parity::even : Parity::velocity;
}

// Calls visit(block slot, block, particle, velocity (m/s), velocity gradient Δx C (m/s)) for all particles,
// blocks in parallel, each block's particles in order.
template <int D, class Real, class Visit>
void for_each_motion(const Grid<D, Real>& grid, const Particles<D, Real>& particles, const Visit& visit) {
    parallel_for(grid.particle_blocks.size(), [&](std::size_t slot) {
        if (particles.begin[slot] == particles.begin[slot + 1]) return;
        const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
        Tile<D, Real> tile;
        load_velocities(grid, slot, parity_of(particles.material), tile.data());
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            Vector<D, Real> velocity;
            Matrix<D, Real> gradient;
            gather<D, Real>(local_position<D, Real>(particles, p), tile.data(), velocity, gradient);
            visit(slot, block, p, velocity, gradient);
        }
    });
}

}  // namespace tidewater::mpm
