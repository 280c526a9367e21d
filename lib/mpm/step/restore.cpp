#include "mpm/step/restore.h"

#include <algorithm>

#include "mpm/base/instantiate.h"
#include "mpm/particles/motion.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {
namespace {

// Adds the momenta that a block's particles have with the velocities of a tile to the strips.
template <int D, class Real>
void carry(const Particles<D, Real>& particles, std::size_t slot, const Real* from, Strips<D, Real>& to) {
    TransferBatch<D, Real> batch;
    const auto mass = static_cast<Real>(particles.mass);
    for_each_batch(particles, slot, [&](std::size_t, int count, const Column<Stored<Real>>* position) {
        locate<D, Real>(position, batch.stencil);
        gather_batch<D, Real>(from, batch);
        velocity_to_momentum(mass, batch);
        scatter_batch<D, Real>(mass, count, batch, to);
    });
}

// The momenta and masses of all tiles after the trip, [particle block][Block<D>::tile_size].
template <int D, class Real>
std::vector<Node<Real>> round_trip(const std::vector<Particles<D, Real>>& bodies, const Grid<D, Real>& grid) {
    std::vector<Node<Real>> tiles(grid.tiles.size());
    parallel_for(grid.particle_blocks.size(), [&](std::size_t slot) {
        alignas(64) Tile<D, Real> from;
        load_velocities(grid, slot, from.data());
        Strips<D, Real> strips{};
        for (const auto& particles : bodies) {
            carry(particles, slot, from.data()->data(), strips);
        }
        Node<Real>* to = tiles.data() + slot * Block<D>::tile_size;
        sum_strips<D, Real>(strips, to->data());
        std::fill(to + Block<D>::tile_nodes, to + Block<D>::tile_size, Node<Real>::Zero());
        fold<D, Real>(grid.layout, block_at<D>(grid.particle_blocks[slot]), Parity::velocity, to);
    });
    return tiles;
}

}  // namespace

template <int D, class Real>
void restore_velocities(const std::vector<Particles<D, Real>>& bodies, Grid<D, Real>& grid,
                        Vector<D, double>& wall_impulse) {
    const std::vector<Node<Real>> tiles = round_trip(bodies, grid);
    std::vector<Vector<D, double>> given(grid.node_blocks.size(), Vector<D, double>::Zero());
    parallel_for(given.size(), [&](std::size_t slot) {
        Node<Real> carried[Block<D>::nodes];
        sum_tiles<D, Real>(grid.tiles_of_node[slot], tiles.data(), carried);
        momentum_to_velocity<D, Real>(Real(0), carried);
        Node<Real>* nodes = grid.block_nodes(slot);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const auto lost = (nodes[n] - carried[n]).template head<D>().eval();
            nodes[n].template head<D>() += lost;
            given[slot] += static_cast<double>(nodes[n][mass_lane]) * lost.template cast<double>().matrix();
        }
    });
    for (const auto& momentum : given) wall_impulse += momentum;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                       \
    template void restore_velocities(const std::vector<Particles<D, Real>>&, Grid<D, Real>&, \
                                     Vector<D, double>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
