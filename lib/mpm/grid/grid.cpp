#include "mpm/grid/grid.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/parallel.h"
#include "mpm/base/batch.h"
#include "mpm/base/instantiate.h"
#include "mpm/base/row.h"

namespace tidewater::mpm {
namespace {

// Calls visit.operator()<k>() for the neighbours k in order. k is a template argument so that the loops over
// shared nodes have constant bounds.
template <int D, class Visit>
void for_each_neighbour(const Visit& visit) {
    [&]<int... k>(std::integer_sequence<int, k...>) { (visit.template operator()<k>(), ...); }
    (std::make_integer_sequence<int, Block<D>::neighbours>{});
}

// Calls visit(node, tile_node, count) for the runs of nodes along the last axis that a block of nodes shares
// with the tile of its neighbour k. A tile covers the nodes −1 … width + 1 of its own block.
template <int D, int k, class Visit>
void for_each_shared_run(const Visit& visit) {
    constexpr int width = Block<D>::width;
    constexpr auto first = [](int axis) { return neighbour_offset<D>(k, axis) * Block<D>::width - 1; };
    constexpr auto begin = [first](int axis) { return std::max(0, first(axis)); };
    constexpr auto end = [first](int axis) {
        return std::min(Block<D>::width, first(axis) + Block<D>::tile_width);
    };
    constexpr auto shift = [first](int axis) { return -first(axis); };
    constexpr int z = D - 1;
    for (int x = begin(0); x < end(0); ++x) {
        if constexpr (D == 2) {
            visit(x * width + begin(z), (x + shift(0)) * Block<D>::tile_width + begin(z) + shift(z),
                  end(z) - begin(z));
        } else {
            for (int y = begin(1); y < end(1); ++y) {
                visit((x * width + y) * width + begin(z),
                      ((x + shift(0)) * Block<D>::tile_width + y + shift(1)) * Block<D>::tile_width +
                          begin(z) + shift(z),
                      end(z) - begin(z));
            }
        }
    }
}

// Spreads the bits of `number` to every D-th bit of a key.
template <int D>
BlockKey spread_bits(std::uint32_t number) {
    BlockKey spread = 0;
    for (int bit = 0; bit < 64 / D; ++bit) spread |= BlockKey{number >> bit & 1u} << (D * bit);
    return spread;
}

// The inverse of spread_bits: collects every D-th bit of a key.
template <int D>
int gather_bits(BlockKey key) {
    std::uint32_t number = 0;
    for (int bit = 0; bit < 64 / D; ++bit) {
        number |= static_cast<std::uint32_t>(key >> (D * bit) & 1u) << bit;
    }
    return static_cast<int>(number);
}

// A node block that a tile reaches.
struct Link {
    BlockKey node_block;
    int tile, neighbour;
    bool operator<(const Link& other) const {
        return std::pair(node_block, tile) < std::pair(other.node_block, other.tile);
    }
};

template <int D>
std::vector<Link> sorted_links(const std::vector<BlockKey>& particle_blocks) {
    constexpr auto neighbours = static_cast<std::size_t>(Block<D>::neighbours);
    std::vector<Link> links(particle_blocks.size() * neighbours);
    parallel_for(particle_blocks.size(), [&](std::size_t slot) {
        const Index<D> block = block_at<D>(particle_blocks[slot]);
        for (int k = 0; k < Block<D>::neighbours; ++k) {
            Index<D> other = block;
            for (int axis = 0; axis < D; ++axis) {
                other[static_cast<std::size_t>(axis)] += neighbour_offset<D>(k, axis);
            }
            links[slot * neighbours + static_cast<std::size_t>(k)] = {block_key<D>(other),
                                                                      static_cast<int>(slot), k};
        }
    });
    tbb::parallel_sort(links.begin(), links.end());
    return links;
}

// Copies the values of nodes that existed before. Both lists of blocks are ascending.
template <int D, class Real>
void keep_nodes(const std::vector<BlockKey>& old_blocks, const std::vector<Node<Real>>& old_nodes,
                Grid<D, Real>& grid) {
    std::size_t from = 0;
    for (std::size_t slot = 0; slot < grid.node_blocks.size(); ++slot) {
        while (from < old_blocks.size() && old_blocks[from] < grid.node_blocks[slot]) ++from;
        if (from == old_blocks.size() || old_blocks[from] != grid.node_blocks[slot]) continue;
        std::copy_n(old_nodes.data() + from * Block<D>::nodes, Block<D>::nodes, grid.block_nodes(slot));
    }
}

}  // namespace

template <int D>
BlockKey block_key(const Index<D>& block) {
    BlockKey key = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
        key |= spread_bits<D>(static_cast<std::uint32_t>(block[axis])) << (D - 1 - axis);
    }
    return key;
}

template <int D>
Index<D> block_at(BlockKey key) {
    Index<D> block;
    for (std::size_t axis = 0; axis < D; ++axis) block[axis] = gather_bits<D>(key >> (D - 1 - axis));
    return block;
}

template <int D, class Real>
void activate(Grid<D, Real>& grid, std::vector<BlockKey> particle_blocks) {
    if (particle_blocks == grid.particle_blocks) return;
    grid.particle_blocks = std::move(particle_blocks);
    const std::vector<Link> links = sorted_links<D>(grid.particle_blocks);
    const std::vector<BlockKey> old_blocks = std::move(grid.node_blocks);
    const std::vector<Node<Real>> old_nodes = std::move(grid.nodes);
    grid.node_blocks.clear();
    grid.tiles_of_node.clear();
    grid.nodes_of_tile.resize(grid.particle_blocks.size());
    for (const Link& link : links) {
        if (grid.node_blocks.empty() || grid.node_blocks.back() != link.node_block) {
            grid.node_blocks.push_back(link.node_block);
            grid.tiles_of_node.emplace_back().fill(-1);
        }
        const auto k = static_cast<std::size_t>(link.neighbour);
        const auto last = static_cast<std::size_t>(Block<D>::neighbours - 1);
        grid.nodes_of_tile[static_cast<std::size_t>(link.tile)][k] =
            static_cast<int>(grid.node_blocks.size() - 1);
        grid.tiles_of_node.back()[last - k] = link.tile;  // the offset is reversed, seen from the node block
    }
    grid.tiles.resize(grid.particle_blocks.size() * Block<D>::tile_size);
    grid.nodes.assign(grid.node_blocks.size() * Block<D>::nodes, Node<Real>::Zero());
    keep_nodes(old_blocks, old_nodes, grid);
    grid.linked_anew = true;
}

template <int D>
NodeBox<D> reached_nodes(
    const std::array<int, static_cast<std::size_t>(Block<D>::neighbours)>& tiles_of_node) {
    constexpr int width = Block<D>::width;
    // Of the neighbour before, in the middle and behind along an axis.
    constexpr int begin[] = {0, 0, width - 1}, end[] = {Block<D>::tile_width - width - 1, width, width};
    NodeBox<D> box;
    box.begin.fill(width);
    for (int k = 0; k < Block<D>::neighbours; ++k) {
        if (tiles_of_node[static_cast<std::size_t>(k)] < 0) continue;
        for (int axis = 0; axis < D; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const int side = neighbour_offset<D>(k, axis) + 1;
            box.begin[a] = std::min(box.begin[a], begin[side]);
            box.end[a] = std::max(box.end[a], end[side]);
        }
    }
    return box;
}

template <int D, class Real>
void sum_tiles(const typename Grid<D, Real>::Neighbours& tiles_of_node, const Node<Real>* tiles,
               Node<Real>* nodes, const NodeBox<D>& box) {
    box.for_each_run([&](int node, int count) { std::fill_n(nodes + node, count, Node<Real>::Zero()); });
    for_each_neighbour<D>([&]<int k> {
        if (tiles_of_node[k] < 0) return;
        const Node<Real>* tile = tiles + static_cast<std::size_t>(tiles_of_node[k]) * Block<D>::tile_size;
        for_each_shared_run<D, k>([&](int node, int tile_node, int count) {
            for (int n = 0; n < count; ++n) nodes[node + n] += tile[tile_node + n];
        });
    });
}

template <int D, class Real>
void load_tile(const Grid<D, Real>& grid, const std::vector<Node<Real>>& nodes, std::size_t slot,
               Node<Real>* tile) {
    for_each_neighbour<D>([&]<int k> {
        const auto other = static_cast<std::size_t>(grid.nodes_of_tile[slot][k]);
        const Node<Real>* from = nodes.data() + other * Block<D>::nodes;
        for_each_shared_run<D, Block<D>::neighbours - 1 - k>([&](int node, int tile_node, int count) {
            for (int n = 0; n < count; ++n) tile[tile_node + n] = from[node + n];
        });
    });
    std::fill(tile + Block<D>::tile_nodes, tile + Block<D>::tile_size, Node<Real>::Zero());
}

template <int D, class Real>
void momentum_to_velocity(Real kick, Node<Real>* nodes, const NodeBox<D>& box) {
    using R = Row<Real>;
    R kicks{}, only_mass{};
    for (int n = 0; n < lanes; ++n) {
        if (n % 4 == D - 1) kicks[n] = kick;
        if (n % 4 == mass_lane) only_mass[n] = Real(1);
    }
    const auto turn = [&](Real* at) {
        const R row = load_row<Real>(at);
        const R mass =
            __builtin_shufflevector(row, row, 3, 3, 3, 3, 7, 7, 7, 7, 11, 11, 11, 11, 15, 15, 15, 15);
        const R velocity = row / mass + kicks;
        const R moving = only_mass != R{} ? row : velocity;
        store(mass > R{} + std::numeric_limits<Real>::min() ? moving : R{}, at);
    };
    NodeBox<D> rows = box;  // widened to whole rows of four nodes
    int &begin = rows.begin[D - 1], &end = rows.end[D - 1];
    begin = begin / 4 * 4;
    end = (end + 3) / 4 * 4;
    rows.for_each_run([&](int node, int count) {
        for (int n = node; n < node + count; n += 4) turn(nodes[n].data());
    });
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                 \
    template void momentum_to_velocity<D, Real>(Real, Node<Real>*, const NodeBox<D>&);                 \
    template void activate(Grid<D, Real>&, std::vector<BlockKey>);                                     \
    template void sum_tiles<D, Real>(const Grid<D, Real>::Neighbours&, const Node<Real>*, Node<Real>*, \
                                     const NodeBox<D>&);                                               \
    template void load_tile(const Grid<D, Real>&, const std::vector<Node<Real>>&, std::size_t, Node<Real>*);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)
template NodeBox<2> reached_nodes<2>(const std::array<int, Block<2>::neighbours>&);
template NodeBox<3> reached_nodes<3>(const std::array<int, Block<3>::neighbours>&);
template BlockKey block_key<2>(const Index<2>&);
template BlockKey block_key<3>(const Index<3>&);
template Index<2> block_at<2>(BlockKey);
template Index<3> block_at<3>(BlockKey);

}  // namespace tidewater::mpm
