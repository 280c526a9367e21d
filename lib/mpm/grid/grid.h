// The background grid in blocks, only where particles are.
//
// The box of the scene is cut into blocks of Block<D>::width cells per axis. Blocks are named by keys that
// follow the Morton curve: neighbours in space are mostly near in memory, and empty space costs nothing.
// Blocks that hold particles own a *tile* (their nodes and a rim of the neighbours'); blocks that a tile
// reaches own *nodes*. Particles are scattered into their own block's tile, and each node then sums its up to
// 3^D tiles in a fixed order: no two threads write the same number, and a sum never depends on who was first.
// Test: tests/unit/mpm/grid/grid_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mpm/grid/stencil.h"

namespace tidewater::mpm {

using BlockKey = std::uint64_t;

// How a wall mirrors what lies before it (mpm/grid/mirror.h).
enum class Mirror { none, slip, stick };

// [axis][0: at the origin, 1: at the far end]
template <int D>
using Mirrors = std::array<std::array<Mirror, 2>, static_cast<std::size_t>(D)>;

// How space is numbered. Node n of an axis lies at n Δx; the walls lie at node 0 and node cells[axis].
template <int D>
struct Layout {
    double cell_size = 0.0;  // Δx, m
    Index<D> cells{};        // of the box
    Mirrors<D> mirrors{};

    // The block that holds node n of an axis is n / width + 2 rounded down: particles may reach a cell past a
    // wall and tiles a block further, and keys are made of numbers ≥ 0.
    static int first_node(int block_on_axis) { return (block_on_axis - 2) * Block<D>::width; }
};

// Where node n of a block lies; `block` as block_at gives it.
template <int D>
Index<D> node_at(const Layout<D>& layout, const Index<D>& block, int n) {
    Index<D> node = index_of<D>(n, Block<D>::width);
    for (std::size_t axis = 0; axis < D; ++axis) node[axis] += layout.first_node(block[axis]);
    return node;
}

// The Morton key of a block: the bits of its numbers interleaved, the last axis' lowest. Each number must be
// in [0, 2^31) in 2D and [0, 2^21) in 3D: 2 billion cells per axis in 2D, 8 million in 3D.
template <int D>
BlockKey block_key(const Index<D>& block);

template <int D>
Index<D> block_at(BlockKey key);

template <int D, class Real>
struct Grid {
    using Neighbours = std::array<int, static_cast<std::size_t>(Block<D>::neighbours)>;

    Layout<D> layout;
    std::vector<BlockKey> particle_blocks;  // ascending; each owns a tile
    std::vector<BlockKey> node_blocks;      // ascending; each owns Block<D>::nodes nodes
    // Per particle block the places in node_blocks of its 3^D neighbours; per node block their places in
    // particle_blocks, −1 where there is none. Offsets −1, 0, 1 per axis, the last axis fastest.
    std::vector<Neighbours> nodes_of_tile;
    std::vector<Neighbours> tiles_of_node;
    std::vector<Node<Real>> tiles;  // [particle block][Block<D>::tile_size]: momentum and mass
    std::vector<Node<Real>> nodes;  // [node block][Block<D>::nodes]: velocity and mass

    Node<Real>* tile(std::size_t slot) { return tiles.data() + slot * Block<D>::tile_size; }
    Node<Real>* block_nodes(std::size_t slot) { return nodes.data() + slot * Block<D>::nodes; }
    const Node<Real>* block_nodes(std::size_t slot) const { return nodes.data() + slot * Block<D>::nodes; }
};

// Makes tiles and nodes for these blocks (rising, unique) and links them. Nodes that existed before keep
// their values, new ones are zero; tiles are unspecified.
template <int D, class Real>
void activate(Grid<D, Real>& grid, std::vector<BlockKey> particle_blocks);

// Sums the tiles that reach a block of nodes into `nodes`, neighbour by neighbour in the order of offsets.
//     tiles_of_node   as in Grid, of this block
//     tiles           as in Grid
template <int D, class Real>
void sum_tiles(const typename Grid<D, Real>::Neighbours& tiles_of_node, const Node<Real>* tiles,
               Node<Real>* nodes);

// Copies the nodes around particle block `slot` into `tile`, of Block<D>::tile_size nodes.
//     nodes   [node block][Block<D>::nodes], e.g. grid.nodes
template <int D, class Real>
void load_tile(const Grid<D, Real>& grid, const std::vector<Node<Real>>& nodes, std::size_t slot,
               Node<Real>* tile);

// Turns the momenta of one block's nodes into velocities and adds `kick` (m/s) to the last component; nodes
// without mass become zero.
template <int D, class Real>
void momentum_to_velocity(Real kick, Node<Real>* nodes);

}  // namespace tidewater::mpm
