#include "mpm/step/matter.h"

#include <algorithm>

#include "mpm/base/instantiate.h"
#include "mpm/grid/mirror.h"
#include "mpm/particles/motion.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {
namespace {

template <int D, class Real>
bool holds(const std::vector<Particles<D, Real>>& bodies, Material material, std::size_t slot) {
    return std::ranges::any_of(bodies, [&](const auto& particles) {
        return particles.material == material && particles.begin[slot] < particles.begin[slot + 1];
    });
}

template <int D, class Real>
bool has(const std::vector<Particles<D, Real>>& bodies, Material material) {
    return std::ranges::any_of(bodies, [&](const auto& particles) {
        return particles.material == material && particles.size() > 0;
    });
}

// The mass of a block's ice on the nodes of its tile.
template <int D, class Real>
void scatter_ice(const std::vector<Particles<D, Real>>& bodies, const Grid<D, Real>& grid, std::size_t slot,
                 Node<Real>* tile) {
    std::fill_n(tile, Block<D>::tile_size, Node<Real>::Zero());
    for (const auto& particles : bodies) {
        if (particles.material != Material::ice) continue;
        const auto mass = static_cast<Real>(particles.mass);
        StencilBatch<D, Real> s;
        for_each_batch(particles, slot, [&](std::size_t, int count, const auto* position) {
            locate<D, Real>(position, s);
            for (int p = 0; p < count; ++p) {
                for (int row = 0; row < power(3, D - 1); ++row) {
                    Real weight = mass;
                    int node = 0;
                    for (int axis = 0; axis < D - 1; ++axis) {
                        const int offset = index_along<D - 1>(row, 3, axis);
                        weight *= s.weight[axis][offset][p];
                        node = node * Block<D>::tile_width + offset;
                    }
                    Node<Real>* at = tile + s.first[p] + node * Block<D>::tile_width;
                    for (int n = 0; n < 3; ++n) at[n][mass_lane] += weight * s.weight[D - 1][n][p];
                }
            }
        });
    }
    fold<D, Real>(grid.layout, block_at<D>(grid.particle_blocks[slot]), Parity::even, tile);
}

}  // namespace

template <int D, class Real>
NodeMatter<Real> find_matter(const Boundaries<D>& boundaries, const BoundaryStep& step, const Slots& slots,
                             const std::vector<Particles<D, Real>>& bodies, const Grid<D, Real>& grid) {
    NodeMatter<Real> matter;
    if (!tells_matter(boundaries) || !has(bodies, Material::ice)) return matter;
    if (!has(bodies, Material::water)) {
        matter.everywhere = Material::ice;
        return matter;
    }
    std::vector<std::uint8_t> ice(grid.particle_blocks.size()), water(ice.size());
    parallel_for(ice.size(), [&](std::size_t slot) {
        ice[slot] = holds(bodies, Material::ice, slot);
        water[slot] = holds(bodies, Material::water, slot);
    });
    const ActingBoundaries<D> acting = acting_boundaries(grid.layout, boundaries, step);
    matter.nodes_per_block = Block<D>::nodes;
    matter.of_block.assign(grid.node_blocks.size(), Material::water);
    matter.mixed.assign(grid.node_blocks.size(), -1);
    for_each_slot(slots, [&](std::size_t slot) {
        bool any_ice = false, any_water = false;
        for (const int tile : grid.tiles_of_node[slot]) {
            if (tile < 0) continue;
            any_ice = any_ice || ice[static_cast<std::size_t>(tile)] != 0;
            any_water = any_water || water[static_cast<std::size_t>(tile)] != 0;
        }
        if (any_ice && !any_water) matter.of_block[slot] = Material::ice;
        if (any_ice && any_water && tells_matter<D>(acting, block_at<D>(grid.node_blocks[slot])))
            matter.mixed[slot] = 0;
    });

    // Numbers the mixed blocks, and the tiles of ice that reach them, in order.
    std::vector<std::size_t> mixed, tiles;
    std::vector<int> place(ice.size(), -1);  // [particle block] in `tiles`
    for (std::size_t slot = 0; slot < matter.mixed.size(); ++slot) {
        if (matter.mixed[slot] < 0) continue;
        matter.mixed[slot] = static_cast<int>(mixed.size());
        mixed.push_back(slot);
        for (const int tile : grid.tiles_of_node[slot]) {
            if (tile < 0 || ice[static_cast<std::size_t>(tile)] == 0) continue;
            int& at = place[static_cast<std::size_t>(tile)];
            if (at >= 0) continue;
            at = static_cast<int>(tiles.size());
            tiles.push_back(static_cast<std::size_t>(tile));
        }
    }
    std::vector<Node<Real>> masses(tiles.size() * Block<D>::tile_size);
    parallel_for(tiles.size(), [&](std::size_t n) {
        scatter_ice(bodies, grid, tiles[n], masses.data() + n * Block<D>::tile_size);
    });
    matter.ice.resize(mixed.size() * Block<D>::nodes);
    parallel_for(mixed.size(), [&](std::size_t n) {
        auto from = grid.tiles_of_node[mixed[n]];
        for (int& tile : from) tile = tile < 0 ? -1 : place[static_cast<std::size_t>(tile)];
        sum_tiles<D, Real>(from, masses.data(), matter.ice.data() + n * Block<D>::nodes);
    });
    return matter;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                             \
    template NodeMatter<Real> find_matter(const Boundaries<D>&, const BoundaryStep&, const Slots&, \
                                          const std::vector<Particles<D, Real>>&, const Grid<D, Real>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
