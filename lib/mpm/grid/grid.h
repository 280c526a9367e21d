// The background grid: blocks of nodes, which exist only near particles.
//
// The box of the scene is divided into blocks of Block<D>::width cells per axis. Their keys follow the Morton
// curve, so that neighbours in space are mostly near in memory; empty space costs nothing. A block that holds
// particles owns a *tile*: its nodes and a rim of its neighbours' nodes. A block that a tile reaches owns
// *nodes*. Particles are scattered into the tile of their own block, and then each node sums the tiles that
// contain it (up to 3^D) in a fixed order. So no two threads write the same number, and the order of the
// threads never changes a sum.
// Test: tests/unit/mpm/grid/grid_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mpm/grid/stencil.h"

namespace tidewater::mpm {

using BlockKey = std::uint64_t;

// How a wall mirrors the inside of the box (mpm/grid/mirror.h).
enum class Mirror { none, slip, stick };

// [axis][0: at the origin, 1: at the far end]
template <int D>
using Mirrors = std::array<std::array<Mirror, 2>, static_cast<std::size_t>(D)>;

// The numbering of space. Node n of an axis lies at n Δx; the walls lie at node 0 and node cells[axis].
template <int D>
struct Layout {
    double cell_size = 0.0;  // Δx, m
    Index<D> cells{};        // of the box
    Mirrors<D> mirrors{};

    // Node n of an axis belongs to block ⌊n / width⌋ + 2. The 2 keeps block numbers, of which keys are made,
    // at 0 or above: particles may be up to a cell beyond a wall, and their tiles reach a block further.
    static int first_node(int block_on_axis) { return (block_on_axis - 2) * Block<D>::width; }
};

// The index in the box of node n of a block; `block` is what block_at returns.
template <int D>
Index<D> node_at(const Layout<D>& layout, const Index<D>& block, int n) {
    Index<D> node = index_of<D>(n, Block<D>::width);
    for (std::size_t axis = 0; axis < D; ++axis) node[axis] += layout.first_node(block[axis]);
    return node;
}

// The Morton key of a block: the bits of its numbers interleaved, the last axis in the lowest bits. Each
// number must be in [0, 2^31) in 2D and in [0, 2^21) in 3D, which allows for 2 billion cells per axis in 2D
// and 8 million in 3D.
template <int D>
BlockKey block_key(const Index<D>& block);

// The inverse of block_key.
template <int D>
Index<D> block_at(BlockKey key);

// A box of nodes within a block: those from begin to end − 1 along each axis.
template <int D>
struct NodeBox {
    Index<D> begin{}, end{};

    static NodeBox all() {
        NodeBox box;
        box.end.fill(Block<D>::width);
        return box;
    }
    // Only nodes from `first` to `last` along an axis, counted in the box of the scene, are left; `block` is
    // what block_at returns.
    void narrow(const Index<D>& block, std::size_t axis, double first, double last) {
        const double origin = Layout<D>::first_node(block[axis]);
        begin[axis] = static_cast<int>(std::max<double>(begin[axis], std::ceil(first - origin)));
        end[axis] = static_cast<int>(std::min<double>(end[axis], std::floor(last - origin) + 1.0));
    }
    // Calls visit(number in the block of a node, count) for the runs of nodes along the last axis, in order.
    template <class Visit>
    void for_each_run(const Visit& visit) const {
        constexpr int width = Block<D>::width, z = D - 1;
        const int count = end[z] - begin[z];
        for (int x = begin[0]; x < end[0]; ++x) {
            if constexpr (D == 2) {
                visit(x * width + begin[z], count);
            } else {
                for (int y = begin[1]; y < end[1]; ++y) visit((x * width + y) * width + begin[z], count);
            }
        }
    }
};

template <int D, class Real>
struct Grid {
    using Neighbours = std::array<int, static_cast<std::size_t>(Block<D>::neighbours)>;

    Layout<D> layout;
    std::vector<BlockKey> particle_blocks;  // ascending; each owns a tile
    std::vector<BlockKey> node_blocks;      // ascending; each owns Block<D>::nodes nodes
    // The 3^D neighbours of each block, ordered by their offsets −1, 0, 1 per axis with the last axis
    // fastest. nodes_of_tile: for each particle block, their slots in node_blocks. tiles_of_node: for each
    // node block, their slots in particle_blocks, or −1 for a neighbour without particles.
    std::vector<Neighbours> nodes_of_tile;
    std::vector<Neighbours> tiles_of_node;
    std::vector<Node<Real>> tiles;  // [particle block][Block<D>::tile_size]: momentum and mass
    std::vector<Node<Real>> nodes;  // [node block][Block<D>::nodes]: velocity and mass
    // Nodes that no tile reaches are zero, unless blocks were linked anew since the last sum.
    bool linked_anew = true;

    Node<Real>* tile(std::size_t slot) { return tiles.data() + slot * Block<D>::tile_size; }
    Node<Real>* block_nodes(std::size_t slot) { return nodes.data() + slot * Block<D>::nodes; }
    const Node<Real>* block_nodes(std::size_t slot) const { return nodes.data() + slot * Block<D>::nodes; }
};

// Makes tiles and nodes for these blocks (ascending, unique) and links them. Nodes that existed before keep
// their values and new ones are zero; the contents of tiles are unspecified.
template <int D, class Real>
void activate(Grid<D, Real>& grid, std::vector<BlockKey> particle_blocks);

// The nodes of a block that its own and its neighbours' tiles reach. Half of all blocks have no particles of
// their own, so that the work on their nodes is that on a row or two.
//     tiles_of_node   entry of Grid::tiles_of_node for this block
template <int D>
NodeBox<D> reached_nodes(
    const std::array<int, static_cast<std::size_t>(Block<D>::neighbours)>& tiles_of_node);

// Sums the tiles that reach a block of nodes into `nodes`, neighbour by neighbour in the order of offsets.
//     tiles_of_node   entry of Grid::tiles_of_node for this block
//     tiles           Grid::tiles, or another array with its layout
//     box             holds the nodes that they reach; the others stay what they are
template <int D, class Real>
void sum_tiles(const typename Grid<D, Real>::Neighbours& tiles_of_node, const Node<Real>* tiles,
               Node<Real>* nodes, const NodeBox<D>& box = NodeBox<D>::all());

// Copies the nodes around particle block `slot` into `tile`, which has Block<D>::tile_size nodes.
//     nodes   [node block][Block<D>::nodes], e.g. grid.nodes
template <int D, class Real>
void load_tile(const Grid<D, Real>& grid, const std::vector<Node<Real>>& nodes, std::size_t slot,
               Node<Real>* tile);

// Turns the momenta of one block's nodes, at least of those in `box`, into velocities and adds `kick` (m/s)
// to their last component. Nodes without mass become zero.
template <int D, class Real>
void momentum_to_velocity(Real kick, Node<Real>* nodes, const NodeBox<D>& box = NodeBox<D>::all());

}  // namespace tidewater::mpm
