#include "mpm/step/nodes.h"

#include <algorithm>

#include "mpm/base/instantiate.h"
#include "mpm/particles/motion.h"

namespace tidewater::mpm {
namespace {

// Max. |v|² of the nodes of a block that lie in the box; NaN if a velocity is not finite.
template <int D, class Real>
double max_speed2_of(const Node<Real>* nodes, const NodeBox<D>& box) {
    constexpr int width = Block<D>::width;
    Real of_lane[width]{}, poison[width]{};
    box.for_each_run([&](int first, int count) {
        for (int n = 0; n < count; ++n) {
            const Real* node = nodes[first + n].data();
            Real speed2 = node[0] * node[0] + node[1] * node[1];
            if constexpr (D == 3) speed2 += node[2] * node[2];
            of_lane[n] = std::max(of_lane[n], speed2);
            poison[n] += Real(0) * speed2;
        }
    });
    double max2 = 0.0;
    for (int n = 0; n < width; ++n) max2 = std::max(max2, static_cast<double>(of_lane[n]));
    for (int n = 0; n < width; ++n) max2 += static_cast<double>(poison[n]);
    return max2;
}

// The nodes on which there is work: those that tiles reach or, once after blocks were linked anew, all, since
// the others still have to be cleared.
template <int D, class Real>
NodeBox<D> nodes_at_work(const Grid<D, Real>& grid, std::size_t slot) {
    return grid.linked_anew ? NodeBox<D>::all() : reached_nodes<D>(grid.tiles_of_node[slot]);
}

}  // namespace

template <int D, class Real>
void sum_momenta(Real kick, std::size_t slot, Grid<D, Real>& grid) {
    Node<Real>* nodes = grid.block_nodes(slot);
    const NodeBox<D> box = nodes_at_work(grid, slot);
    sum_tiles<D, Real>(grid.tiles_of_node[slot], grid.tiles.data(), nodes, box);
    momentum_to_velocity<D, Real>(kick, nodes, box);
}

template <int D, class Real>
NodeResult<D> bound_velocities(const ActingBoundaries<D>& acting, const NodeMatter<Real>& matter,
                               std::size_t slot, std::span<float> grip, Grid<D, Real>& grid) {
    Node<Real>* nodes = grid.block_nodes(slot);
    float* own_grip = grip.empty() ? nullptr : grip.data() + slot * Block<D>::nodes;
    const NodeBox<D> box = reached_nodes<D>(grid.tiles_of_node[slot]);
    NodeResult<D> result;
    result.action = apply_boundaries<D, Real>(grid.layout, acting, block_at<D>(grid.node_blocks[slot]),
                                              matter.of(slot), own_grip, nodes, box);
    result.max_speed2 = max_speed2_of<D, Real>(nodes, box);
    return result;
}

template <int D, class Real>
void add_unfolding_impulse(const Slots& particle_slots, Grid<D, Real>& grid,
                           Vector<D, double>& wall_impulse) {
    std::vector<Vector<D, double>> of_block(particle_slots.size(), Vector<D, double>::Zero());
    parallel_for(particle_slots.size(), [&](std::size_t n) {
        const std::size_t slot = particle_slots[n];
        const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
        if (!has_mirror<D>(grid.layout, block)) return;
        Tile<D, Real> tile;
        load_velocities(grid, slot, tile.data());
        of_block[n] = unfolding_impulse<D, Real>(grid.layout, block, tile.data(), grid.tile(slot));
    });
    for (const auto& impulse : of_block) wall_impulse += impulse;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                           \
    template void sum_momenta(Real, std::size_t, Grid<D, Real>&);                                \
    template NodeResult<D> bound_velocities(const ActingBoundaries<D>&, const NodeMatter<Real>&, \
                                            std::size_t, std::span<float>, Grid<D, Real>&);      \
    template void add_unfolding_impulse(const Slots&, Grid<D, Real>&, Vector<D, double>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
