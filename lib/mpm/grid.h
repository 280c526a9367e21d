// The background grid in blocks, only where particles are.
//
// The box of the scene is cut into blocks of Block<D>::width cells per axis, with two blocks more on each
// side. Blocks that hold particles own a *tile* (their nodes and a rim of the neighbours'); blocks that a
// tile reaches own *nodes*. Particles are scattered into their own block's tile, and each node then sums its
// up to 3^D tiles in a fixed order: no two threads write the same number, and a sum never depends on who was
// first.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mpm/stencil.h"

namespace tidewater::mpm {

template <int D>
using Index = std::array<int, D>;

// How space is numbered. Node n of an axis lies at n Δx; the walls lie at node 0 and node cells[axis].
template <int D>
struct Layout {
    double cell_size = 0.0;  // Δx, m
    Index<D> cells{};        // of the box
    Index<D> blocks{};       // with the rim; block 0 of an axis starts at node −2 width

    Layout() = default;
    Layout(double dx, const Index<D>& box_cells);

    int block_count() const;
    int block_index(const Index<D>& block) const;  // row-major, last axis fastest
    Index<D> block_at(int index) const;
    int first_node(int block_on_axis) const { return (block_on_axis - 2) * Block<D>::width; }
};

template <int D, class Real>
struct Grid {
    using Neighbours = std::array<int, static_cast<std::size_t>(Block<D>::neighbours)>;

    Layout<D> layout;
    std::vector<int> particle_blocks;  // block indices in rising order; each owns a tile
    std::vector<int> node_blocks;      // block indices in rising order; each owns Block<D>::nodes nodes
    std::vector<Neighbours>
        nodes_of_tile;  // per particle block: the slots in node_blocks of its 3^D neighbours
    std::vector<Neighbours>
        tiles_of_node;              // per node block: the slots in particle_blocks, −1 where there is none
    std::vector<Node<Real>> tiles;  // [particle block][Block<D>::tile_nodes]
    std::vector<Node<Real>> nodes;  // [node block][Block<D>::nodes]

    Node<Real>* tile(std::size_t slot) { return tiles.data() + slot * Block<D>::tile_nodes; }
    Node<Real>* block_nodes(std::size_t slot) { return nodes.data() + slot * Block<D>::nodes; }
};

// Makes tiles and nodes for these blocks (rising, unique) and links them. Contents are unspecified.
template <int D, class Real>
void activate(Grid<D, Real>& grid, std::vector<int> particle_blocks);

// Sums the tiles that reach node block `slot` into `nodes`, neighbour by neighbour in the order of their
// indices.
template <int D, class Real>
void sum_tiles(const Grid<D, Real>& grid, std::size_t slot, Node<Real>* nodes);

// Copies the nodes around particle block `slot` into `tile`.
template <int D, class Real>
void load_tile(const Grid<D, Real>& grid, std::size_t slot, Node<Real>* tile);

// Turns the momenta of one block's nodes into velocities; nodes without mass become zero.
template <int D, class Real>
void divide_by_mass(Node<Real>* nodes);

}  // namespace tidewater::mpm
