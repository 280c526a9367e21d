#include "mpm/grid.h"

#include <algorithm>
#include <limits>

#include "core/parallel.h"

namespace tidewater::mpm {
namespace {

// Calls visit(k, offset) for the 3^D neighbours, offsets −1, 0, 1 per axis, last axis fastest.
template <int D, class Visit>
void for_each_neighbour(const Visit& visit) {
    for (int k = 0; k < Block<D>::neighbours; ++k) {
        Index<D> offset;
        for (int axis = D - 1, rest = k; axis >= 0; --axis, rest /= 3) {
            offset[static_cast<std::size_t>(axis)] = rest % 3 - 1;
        }
        visit(static_cast<std::size_t>(k), offset);
    }
}

// Calls visit(node, tile_node, count) for the runs along the last axis that a block of nodes shares with the
// tile of the block at `offset` from it. A tile covers the nodes −1 … width + 1 of its own block.
template <int D, class Visit>
void for_each_shared_run(const Index<D>& offset, const Visit& visit) {
    constexpr int width = Block<D>::width;
    Index<3> begin{}, end{},
        shift{};  // own nodes [begin, end) and what turns them into tile nodes, as (x, y, z)
    end[1] = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const std::size_t to = axis == D - 1 ? 2 : axis;
        begin[to] = std::max(0, offset[axis] * width - 1);
        end[to] = std::min(width, offset[axis] * width + width + 2);
        shift[to] = 1 - offset[axis] * width;
    }
    for (int x = begin[0]; x < end[0]; ++x) {
        for (int y = begin[1]; y < end[1]; ++y) {
            const int node_row = D == 3 ? x * width + y : x;
            const int tile_row = D == 3 ? (x + shift[0]) * Block<D>::tile_width + y + shift[1] : x + shift[0];
            visit(node_row * width + begin[2], tile_row * Block<D>::tile_width + begin[2] + shift[2],
                  end[2] - begin[2]);
        }
    }
}

template <int D>
Index<D> moved(Index<D> block, const Index<D>& offset) {
    for (std::size_t axis = 0; axis < D; ++axis) block[axis] += offset[axis];
    return block;
}

}  // namespace

template <int D>
Layout<D>::Layout(double dx, const Index<D>& box_cells) : cell_size(dx), cells(box_cells) {
    // A particle may reach one cell past a wall, and its tile one block further: two blocks of rim on each
    // side.
    for (std::size_t axis = 0; axis < D; ++axis) blocks[axis] = cells[axis] / Block<D>::width + 5;
}

template <int D>
int Layout<D>::block_count() const {
    int count = 1;
    for (const int along : blocks) count *= along;
    return count;
}

template <int D>
int Layout<D>::block_index(const Index<D>& block) const {
    int index = 0;
    for (std::size_t axis = 0; axis < D; ++axis) index = index * blocks[axis] + block[axis];
    return index;
}

template <int D>
Index<D> Layout<D>::block_at(int index) const {
    Index<D> block;
    for (std::size_t axis = D; axis-- > 0; index /= blocks[axis]) block[axis] = index % blocks[axis];
    return block;
}

template <int D, class Real>
void activate(Grid<D, Real>& grid, std::vector<int> particle_blocks) {
    const Layout<D>& layout = grid.layout;
    grid.particle_blocks = std::move(particle_blocks);
    std::vector<int> tile_slot(static_cast<std::size_t>(layout.block_count()), -1);
    std::vector<int> node_slot(tile_slot.size(), -1);
    for (std::size_t slot = 0; slot < grid.particle_blocks.size(); ++slot) {
        tile_slot[static_cast<std::size_t>(grid.particle_blocks[slot])] = static_cast<int>(slot);
        const Index<D> block = layout.block_at(grid.particle_blocks[slot]);
        for_each_neighbour<D>([&](std::size_t, const Index<D>& offset) {
            node_slot[static_cast<std::size_t>(layout.block_index(moved<D>(block, offset)))] = 0;
        });
    }
    grid.node_blocks.clear();
    for (std::size_t index = 0; index < node_slot.size(); ++index) {
        if (node_slot[index] < 0) continue;
        node_slot[index] = static_cast<int>(grid.node_blocks.size());
        grid.node_blocks.push_back(static_cast<int>(index));
    }

    const auto link = [&](const std::vector<int>& from, const std::vector<int>& slots, auto& links) {
        links.resize(from.size());
        parallel_for(from.size(), [&](std::size_t slot) {
            const Index<D> block = layout.block_at(from[slot]);
            for_each_neighbour<D>([&](std::size_t k, const Index<D>& offset) {
                const Index<D> other = moved<D>(block, offset);
                bool inside = true;
                for (std::size_t axis = 0; axis < D; ++axis) {
                    inside = inside && other[axis] >= 0 && other[axis] < layout.blocks[axis];
                }
                links[slot][k] = inside ? slots[static_cast<std::size_t>(layout.block_index(other))] : -1;
            });
        });
    };
    link(grid.particle_blocks, node_slot, grid.nodes_of_tile);
    link(grid.node_blocks, tile_slot, grid.tiles_of_node);
    grid.tiles.resize(grid.particle_blocks.size() * Block<D>::tile_nodes);
    grid.nodes.resize(grid.node_blocks.size() * Block<D>::nodes);
}

template <int D, class Real>
void sum_tiles(const Grid<D, Real>& grid, std::size_t slot, Node<Real>* nodes) {
    for (int n = 0; n < Block<D>::nodes; ++n) nodes[n].setZero();
    for_each_neighbour<D>([&](std::size_t k, const Index<D>& offset) {
        const int other = grid.tiles_of_node[slot][k];
        if (other < 0) return;
        const Node<Real>* tile = grid.tiles.data() + static_cast<std::size_t>(other) * Block<D>::tile_nodes;
        for_each_shared_run<D>(offset, [&](int node, int tile_node, int count) {
            for (int n = 0; n < count; ++n) nodes[node + n] += tile[tile_node + n];
        });
    });
}

template <int D, class Real>
void load_tile(const Grid<D, Real>& grid, std::size_t slot, Node<Real>* tile) {
    for_each_neighbour<D>([&](std::size_t k, const Index<D>& offset) {
        const auto other = static_cast<std::size_t>(grid.nodes_of_tile[slot][k]);
        const Node<Real>* nodes = grid.nodes.data() + other * Block<D>::nodes;
        Index<D> back;  // from the neighbour's nodes to this tile
        for (std::size_t axis = 0; axis < D; ++axis) back[axis] = -offset[axis];
        for_each_shared_run<D>(back, [&](int node, int tile_node, int count) {
            for (int n = 0; n < count; ++n) tile[tile_node + n] = nodes[node + n];
        });
    });
}

template <int D, class Real>
void divide_by_mass(Node<Real>* nodes) {
    for (int n = 0; n < Block<D>::nodes; ++n) {
        const Real mass = nodes[n][mass_lane];
        if (!(mass > std::numeric_limits<Real>::min())) {
            nodes[n].setZero();
            continue;
        }
        nodes[n] *= Real(1) / mass;
        nodes[n][mass_lane] = mass;
    }
}

#define TIDEWATER_INSTANTIATE(D, Real)                                       \
    template void divide_by_mass<D, Real>(Node<Real>*);                      \
    template void activate(Grid<D, Real>&, std::vector<int>);                \
    template void sum_tiles(const Grid<D, Real>&, std::size_t, Node<Real>*); \
    template void load_tile(const Grid<D, Real>&, std::size_t, Node<Real>*);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)
template struct Layout<2>;
template struct Layout<3>;

}  // namespace tidewater::mpm
