#include "mpm/step/crowding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "mpm/base/instantiate.h"
#include "mpm/grid/mirror.h"
#include "mpm/materials/water_material.h"

namespace tidewater::mpm {
namespace {

// The nodes of a block's tile and one more on each side, because smoothing reads neighbours. Upward, along
// the last axis, there is yet another one, because whether a node counts depends on the one above it.
template <int D>
struct Surround {
    static constexpr int rim = 2, side = Block<D>::width + 2 * rim + 1, height = side + 1;
    static constexpr int rows = power(side, D - 1), count = rows * height;
};

template <int D>
constexpr int nodes_along(int axis) {
    return axis == D - 1 ? Surround<D>::height : Surround<D>::side;
}

template <int D>
constexpr int stride_of(int axis) {
    return axis == D - 1 ? 1 : power(Surround<D>::side, D - 2 - axis) * Surround<D>::height;
}

// Calls visit(index in the surround, number of the node block among the 3^D neighbours, node in it, count)
// for each run of nodes along the last axis that lies in one block.
template <int D, class Visit>
void for_each_run(const Visit& visit) {
    constexpr int rim = Surround<D>::rim, side = Surround<D>::side, height = Surround<D>::height;
    constexpr int width = Block<D>::width;
    const auto block_of = [](int n) { return n < rim ? 0 : n < rim + width ? 1 : 2; };
    constexpr int begin[] = {0, rim, rim + width, height};
    for (int row = 0; row < Surround<D>::rows; ++row) {
        int neighbour = 0, node = 0;
        for (int axis = 0; axis < D - 1; ++axis) {
            const int n = index_along<D - 1>(row, side, axis), block = block_of(n);
            neighbour = 3 * neighbour + block;
            node = node * width + n - rim + (1 - block) * width;
        }
        for (int block = 0; block < 3; ++block) {
            visit(row * height + begin[block], 3 * neighbour + block,
                  node * width + begin[block] - rim + (1 - block) * width, begin[block + 1] - begin[block]);
        }
    }
}

// Calls visit(first node, stride, count, index of the wall's plane in the row, inward) for all rows of nodes
// that run along an axis towards a mirroring wall within reach; inward is +1 or −1 along the row.
template <int D, class Visit>
void for_each_row_to_a_wall(const Layout<D>& layout, const Index<D>& block, const Visit& visit) {
    constexpr int rim = Surround<D>::rim;
    for_each_mirror(layout, [&](int axis, std::size_t, Mirror, int node, int inward) {
        const int along = nodes_along<D>(axis), stride = stride_of<D>(axis);
        const int plane = node - layout.first_node(block[static_cast<std::size_t>(axis)]) + rim;
        if (plane < -rim || plane >= along + rim) return;
        for (int start = 0; start < Surround<D>::count; start += stride * along) {
            for (int n = start; n < start + stride; ++n) visit(n, stride, along, plane, inward);
        }
    });
}

// The mass of each node of the surround as a share of a cell of water; infinity where its fill is unknown.
template <int D, class Real>
void load_masses(double water_density, const Grid<D, Real>& grid,
                 const std::vector<std::uint8_t>& unknown_fill, std::size_t slot, Real* fill) {
    constexpr Real unknown = std::numeric_limits<Real>::infinity();
    const auto per_mass = static_cast<Real>(1.0 / (water_density * std::pow(grid.layout.cell_size, D)));
    for_each_run<D>([&](int to, int neighbour, int node, int length) {
        const auto block =
            static_cast<std::size_t>(grid.nodes_of_tile[slot][static_cast<std::size_t>(neighbour)]);
        const Node<Real>* nodes = grid.block_nodes(block) + node;
        for (int n = 0; n < length; ++n) fill[to + n] = per_mass * nodes[n][mass_lane];
        if (unknown_fill.empty()) return;
        const std::uint8_t* marks =
            unknown_fill.data() + block * Block<D>::nodes + static_cast<std::size_t>(node);
        for (int n = 0; n < length; ++n) {
            if (marks[n]) fill[to + n] = unknown;
        }
    });
}

// Writes the values of the tile's nodes into its crowding lane.
template <int D, class Real>
void to_tile(const Real* values, Node<Real>* tile) {
    constexpr int tile_width = Block<D>::tile_width;
    for (int row = 0; row < power(tile_width, D - 1); ++row) {
        int from = 1;  // the tile begins one node inside
        for (int axis = 0; axis < D - 1; ++axis) {
            from += (index_along<D - 1>(row, tile_width, axis) + 1) * stride_of<D>(axis);
        }
        for (int n = 0; n < tile_width; ++n) tile[row * tile_width + n][crowding_lane] = values[from + n];
    }
}

// Doubles the fill of nodes on a mirroring wall, since only half of such a node is in the tank.
template <int D, class Real>
void double_on_walls(const Layout<D>& layout, const Index<D>& block, Real* fill) {
    for_each_row_to_a_wall<D>(layout, block, [&](int row, int stride, int along, int plane, int) {
        if (plane >= 0 && plane < along) fill[row + plane * stride] *= Real(2);
    });
}

// Makes the nodes beyond a mirroring wall images of those inside.
template <int D, class Real>
void reflect_in_walls(const Layout<D>& layout, const Index<D>& block, Real* e) {
    for_each_row_to_a_wall<D>(layout, block, [&](int row, int stride, int along, int plane, int inward) {
        for (int beyond = 1; beyond <= Surround<D>::rim; ++beyond) {
            const int image = plane + inward * beyond, of = plane - inward * beyond;
            if (of < 0 || of >= along || image < 0 || image >= along) continue;
            e[row + of * stride] = e[row + image * stride];
        }
    });
}

// Adds the shares that rigid bodies have of the nodes.
template <int D, class Real>
void add_bodies(const Layout<D>& layout, const std::vector<RigidBody>& bodies, const Index<D>& block,
                Real* fill) {
    constexpr int rim = Surround<D>::rim;
    for (const RigidBody& body : bodies) {
        const NodeRange<D> range = reach_of<D>(layout, body);
        Index<D> first, widths;  // of the part of the surround that the body covers, counted in the surround
        int count = 1;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const int origin = layout.first_node(block[axis]) - rim;
            first[axis] = std::max(range.first[axis] - origin, 0);
            const int last = std::min(range.last[axis] - origin, nodes_along<D>(static_cast<int>(axis)) - 1);
            widths[axis] = std::max(last - first[axis] + 1, 0);
            count *= widths[axis];
        }
        for (int n = 0; n < count; ++n) {
            Index<D> node = index_of<D>(n, widths);
            int to = 0;
            for (std::size_t axis = 0; axis < D; ++axis) {
                node[axis] += first[axis];
                to += node[axis] * stride_of<D>(static_cast<int>(axis));
                node[axis] += layout.first_node(block[axis]) - rim;
            }
            fill[to] += static_cast<Real>(share_of_node<D>(layout, body, node).value);
        }
    }
}

// Smooths by (¼, ½, ¼) along each axis; the outermost nodes keep their values along it.
template <int D, class Real>
void smooth(Real* e) {
    for (int axis = 0; axis < D; ++axis) {
        const int stride = stride_of<D>(axis), along = nodes_along<D>(axis);
        for (int start = 0; start < Surround<D>::count; start += stride * along) {
            for (int n = start; n < start + stride; ++n) {
                Real before = e[n];
                for (int k = 1; k < along - 1; ++k) {
                    Real& here = e[n + k * stride];
                    const Real sum = Real(0.25) * (before + e[n + (k + 1) * stride]) + Real(0.5) * here;
                    before = here;
                    here = sum;
                }
            }
        }
    }
}

// Turns the fill into e, except in the uppermost node of each row, which only serves the one below it.
//     water  fill without rigid bodies
//     fill   fill with rigid bodies; becomes e
template <int D, class Real>
void fill_to_crowding(const Real* water, Real* fill) {
    constexpr int height = Surround<D>::height;
    constexpr auto full = static_cast<Real>(min_fill);
    for (int start = 0; start < Surround<D>::count; start += height) {
        for (int n = start; n < start + height - 1; ++n) {
            const bool counts = (fill[n] > full) | (water[n + 1] > full);
            fill[n] = counts ? fill[n] - Real(1) : Real(0);
        }
    }
}

// Whether a boundary or a solid may hide how full of water a node is, anywhere in the scene.
template <int D, class Real>
bool may_be_unknown(const Boundaries<D>& boundaries, const Layout<D>& layout,
                    const std::vector<Particles<D, Real>>& bodies) {
    bool unknown = false;
    for_each_boundary(boundaries, [&](const auto& boundary) {
        if constexpr (requires { boundary.hides_fill(layout); })
            unknown = unknown || boundary.hides_fill(layout);
    });
    for (const auto& particles : bodies) unknown = unknown || particles.material != Material::water;
    return unknown;
}

// Marks the nodes of a node block that solids reach, and those one cell further: all within two of a node
// that is the nearest of a particle.
template <int D, class Real>
void mark_solids(const Grid<D, Real>& grid, const std::vector<Particles<D, Real>>& bodies,
                 std::size_t node_slot, std::uint8_t* marks) {
    constexpr int reach = 2, width = Block<D>::width, side = width + 2 * reach, count = power(side, D);
    std::array<std::uint8_t, static_cast<std::size_t>(count)>
        near{};  // the block and `reach` nodes around it
    const Index<D> node_block = block_at<D>(grid.node_blocks[node_slot]);
    bool any = false;
    for (const int tile : grid.tiles_of_node[node_slot]) {
        if (tile < 0) continue;
        const auto slot = static_cast<std::size_t>(tile);
        const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
        for (const auto& particles : bodies) {
            if (particles.material == Material::water) continue;
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                int node = 0;
                bool within = true;
                for (std::size_t axis = 0; axis < D; ++axis) {
                    const int n = nearest_node(particles.position[axis][p]) + reach +
                                  (block[axis] - node_block[axis]) * width;
                    within = within && n >= 0 && n < side;
                    node = node * side + n;
                }
                if (!within) continue;
                near[static_cast<std::size_t>(node)] = 1;
                any = true;
            }
        }
    }
    if (!any) return;
    for (int axis = 0; axis < D; ++axis) {  // spreads by `reach` along the axis
        const int stride = power(side, D - 1 - axis);
        for (int start = 0; start < count; start += stride * side) {
            for (int first = start; first < start + stride; ++first) {
                std::uint8_t row[side];
                for (int n = 0; n < side; ++n) row[n] = near[static_cast<std::size_t>(first + n * stride)];
                for (int n = reach; n < side - reach; ++n) {
                    std::uint8_t mark = 0;
                    for (int k = n - reach; k <= n + reach; ++k) mark |= row[k];
                    near[static_cast<std::size_t>(first + n * stride)] = mark;
                }
            }
        }
    }
    for (int n = 0; n < Block<D>::nodes; ++n) {
        int from = 0;
        for (int axis = 0; axis < D; ++axis) from = from * side + index_along<D>(n, width, axis) + reach;
        marks[n] |= near[static_cast<std::size_t>(from)];
    }
}

}  // namespace

template <int D, class Real>
bool has_water(const std::vector<Particles<D, Real>>& bodies, std::size_t slot) {
    return std::ranges::any_of(bodies, [&](const auto& particles) {
        return particles.material == Material::water && particles.begin[slot] < particles.begin[slot + 1];
    });
}

template <int D, class Real>
std::vector<std::uint8_t> find_unknown_fill(const Parameters<D>& parameters, double time,
                                            const Grid<D, Real>& grid,
                                            const std::vector<Particles<D, Real>>& bodies) {
    const Boundaries<D>& boundaries = parameters.boundaries;
    if (!keeps_to_room(parameters.water) || !may_be_unknown(boundaries, grid.layout, bodies)) return {};
    std::vector<std::uint8_t> unknown(grid.nodes.size(), 0);
    parallel_for(grid.node_blocks.size(), [&](std::size_t slot) {
        const auto& tiles = grid.tiles_of_node[slot];
        const auto wet = [&](int tile) {
            return tile >= 0 && has_water(bodies, static_cast<std::size_t>(tile));
        };
        if (std::ranges::none_of(tiles, wet)) return;  // no water reads these nodes
        const Index<D> block = block_at<D>(grid.node_blocks[slot]);
        std::uint8_t* marks = unknown.data() + slot * Block<D>::nodes;
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const Index<D> node = node_at(grid.layout, block, n);
            bool hidden = false;
            for_each_boundary(boundaries, [&](const auto& boundary) {
                if constexpr (requires { boundary.hides_fill_at(grid.layout, time, node); })
                    hidden = hidden || boundary.hides_fill_at(grid.layout, time, node);
            });
            marks[n] = hidden;
        }
        mark_solids(grid, bodies, slot, marks);
    });
    return unknown;
}

template <int D, class Real>
void load_crowding(double water_density, const Grid<D, Real>& grid, const std::vector<RigidBody>& rigid,
                   const std::vector<std::uint8_t>& unknown_fill, std::size_t slot, Node<Real>* tile) {
    constexpr int count = Surround<D>::count;
    alignas(64) Real e[count], water[count];
    load_masses<D>(water_density, grid, unknown_fill, slot, e);
    const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
    double_on_walls<D>(grid.layout, block, e);
    std::copy_n(e, count, water);
    add_bodies(grid.layout, rigid, block, e);
    fill_to_crowding<D>(water, e);
    reflect_in_walls<D>(grid.layout, block, e);
    smooth<D>(e);
    to_tile<D>(e, tile);
}

template <int D, class Real>
void load_fill(double water_density, const Grid<D, Real>& grid, const std::vector<RigidBody>& rigid,
               std::size_t slot, Node<Real>* tile) {
    alignas(64) Real fill[Surround<D>::count];
    load_masses<D>(water_density, grid, {}, slot, fill);
    const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
    double_on_walls<D>(grid.layout, block, fill);
    add_bodies(grid.layout, rigid, block, fill);
    reflect_in_walls<D>(grid.layout, block, fill);
    to_tile<D>(fill, tile);
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                       \
    template bool has_water(const std::vector<Particles<D, Real>>&, std::size_t);                            \
    template std::vector<std::uint8_t> find_unknown_fill(const Parameters<D>&, double, const Grid<D, Real>&, \
                                                         const std::vector<Particles<D, Real>>&);            \
    template void load_crowding(double, const Grid<D, Real>&, const std::vector<RigidBody>&,                 \
                                const std::vector<std::uint8_t>&, std::size_t, Node<Real>*);                 \
    template void load_fill(double, const Grid<D, Real>&, const std::vector<RigidBody>&, std::size_t,        \
                            Node<Real>*);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
