#include "mpm/step/restore.h"

#include <algorithm>

#include "mpm/particles/motion.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {
namespace {

// Adds the velocities that a block's particles read from a tile, as momenta, to the strips.
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

// [particle block][Block<D>::tile_size]: momenta and masses after the trip.
template <int D, class Real>
std::vector<Node<Real>> round_trip(const Simulation<D, Real>& s) {
    std::vector<Node<Real>> tiles(s.grid.tiles.size());
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        alignas(64) Tile<D, Real> from;
        load_velocities(s.grid, slot, from.data());
        Strips<D, Real> strips{};
        for (const auto& particles : s.bodies) {
            carry(particles, slot, from.data()->data(), strips);
        }
        Node<Real>* to = tiles.data() + slot * Block<D>::tile_size;
        sum_strips<D, Real>(strips, to->data());
        std::fill(to + Block<D>::tile_nodes, to + Block<D>::tile_size, Node<Real>::Zero());
        fold<D, Real>(s.grid.layout, block_at<D>(s.grid.particle_blocks[slot]), Parity::velocity, to);
    });
    return tiles;
}

}  // namespace

template <int D, class Real>
void restore_velocities(Simulation<D, Real>& s) {
    const std::vector<Node<Real>> tiles = round_trip(s);
    std::vector<Vector<D, double>> given(s.grid.node_blocks.size(), Vector<D, double>::Zero());
    parallel_for(given.size(), [&](std::size_t slot) {
        Node<Real> carried[Block<D>::nodes];
        sum_tiles<D, Real>(s.grid.tiles_of_node[slot], tiles.data(), carried);
        momentum_to_velocity<D, Real>(Real(0), carried);
        Node<Real>* nodes = s.grid.block_nodes(slot);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const auto lost = (nodes[n] - carried[n]).template head<D>().eval();
            nodes[n].template head<D>() += lost;
            given[slot] += static_cast<double>(nodes[n][mass_lane]) * lost.template cast<double>().matrix();
        }
    });
    for (const auto& momentum : given) s.wall_impulse += momentum;
}

#define TIDEWATER_INSTANTIATE(D, Real) template void restore_velocities(Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
