#include "mpm/step/crowding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"

namespace tidewater::mpm {
namespace {

// The nodes of a block's tile and one more on each side, of which smoothing needs the neighbours; and
// upwards, along the last axis, still one, since whether a node counts depends on the one above it.
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

// Calls visit(index in the surround, place of the node block among the 3^D, node in it, count) for runs along
// the last axis.
template <int D, class Visit>
void for_each_run(const Visit& visit) {
    constexpr int rim = Surround<D>::rim, side = Surround<D>::side, height = Surround<D>::height;
    constexpr int width = Block<D>::width;
    const auto block_of = [](int n) { return n < rim ? 0 : n < rim + width ? 1 : 2; };
    constexpr int begin[] = {0, rim, rim + width, height};
    for (int row = 0; row < Surround<D>::rows; ++row) {
        int neighbour = 0, node = 0;
        for (int axis = 0; axis < D - 1; ++axis) {
            const int n = row / power(side, D - 2 - axis) % side, block = block_of(n);
            neighbour = 3 * neighbour + block;
            node = node * width + n - rim + (1 - block) * width;
        }
        for (int block = 0; block < 3; ++block) {
            visit(row * height + begin[block], 3 * neighbour + block,
                  node * width + begin[block] - rim + (1 - block) * width, begin[block + 1] - begin[block]);
        }
    }
}

// Calls visit(first node, stride, nodes, where in it the wall lies, which way is inward) for all rows of
// nodes along an axis at whose end or beginning there is a mirroring wall in reach.
template <int D, class Visit>
void for_each_row_to_a_wall(const Layout<D>& layout, const Index<D>& block, const Visit& visit) {
    constexpr int rim = Surround<D>::rim;
    for (int axis = 0; axis < D; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const int along = nodes_along<D>(axis), stride = stride_of<D>(axis);
        for (const std::size_t far : {std::size_t{0}, std::size_t{1}}) {
            if (layout.mirrors[a][far] == Mirror::none) continue;
            const int plane = (far ? layout.cells[a] : 0) - layout.first_node(block[a]) + rim;
            if (plane < -rim || plane >= along + rim) continue;
            for (int start = 0; start < Surround<D>::count; start += stride * along) {
                for (int n = start; n < start + stride; ++n) visit(n, stride, along, plane, far ? -1 : 1);
            }
        }
    }
}

// Nodes on a mirroring wall are half in the tank.
template <int D, class Real>
void double_on_walls(const Layout<D>& layout, const Index<D>& block, Real* fill) {
    for_each_row_to_a_wall<D>(layout, block, [&](int row, int stride, int along, int plane, int) {
        if (plane >= 0 && plane < along) fill[row + plane * stride] *= Real(2);
    });
}

// What lies beyond a mirroring wall is the image of what lies before.
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

// What rigid bodies fill of the nodes.
template <int D, class Real>
void add_bodies(const Simulation<D, Real>& s, const Index<D>& block, Real* fill) {
    constexpr int rim = Surround<D>::rim;
    const Layout<D>& layout = s.grid.layout;
    for (const RigidBody& body : s.rigid) {
        const NodeRange<D> range = reach_of<D>(layout, body);
        Index<D> first, last;  // counted in the surround
        int rows = 1;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const int origin = layout.first_node(block[axis]) - rim;
            first[axis] = std::max(range.first[axis] - origin, 0);
            last[axis] = std::min(range.last[axis] - origin, nodes_along<D>(static_cast<int>(axis)) - 1);
            rows *= std::max(last[axis] - first[axis] + 1, 0);
        }
        for (int n = 0; n < rows; ++n) {
            Index<D> node;
            int to = 0, rest = n;
            for (std::size_t axis = D; axis-- > 0;) {
                const int along = last[axis] - first[axis] + 1;
                node[axis] = first[axis] + rest % along;
                rest /= along;
                to += node[axis] * stride_of<D>(static_cast<int>(axis));
                node[axis] += layout.first_node(block[axis]) - rim;
            }
            fill[to] += static_cast<Real>(share_of_node<D>(layout, body, node).value);
        }
    }
}

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

// From the fill without and with rigid bodies to e, except in the uppermost nodes of each row, which serve
// the ones below them alone.
template <int D, class Real>
void fill_to_crowding(const Real* water, Real* fill) {
    constexpr int height = Surround<D>::height;
    constexpr auto least = static_cast<Real>(least_fill);
    for (int start = 0; start < Surround<D>::count; start += height) {
        for (int n = start; n < start + height - 1; ++n) {
            const bool counts = (fill[n] > least) | (water[n + 1] > least);
            fill[n] = counts ? fill[n] - Real(1) : Real(0);
        }
    }
}

// Whether the ground reaches into what a node's spline covers.
template <int D>
bool beside_bed(const Layout<D>& layout, const Bed<D>& bed, const Index<D>& node) {
    if (!bed.exists()) return false;
    Vector<D - 1, double> at;
    for (int axis = 0; axis < D - 1; ++axis) {
        at[axis] = layout.cell_size * node[static_cast<std::size_t>(axis)];
    }
    const double above = layout.cell_size * node[D - 1] - bed.height(at);
    const double normal_z = 1.0 / std::sqrt(1.0 + bed.slope(at, layout.cell_size).squaredNorm());
    return above * normal_z < 1.5 * layout.cell_size;
}

// Whether a node lies beside something that holds nodes without mirroring them.
template <int D>
bool beside_held(const Layout<D>& layout, const Boundaries<D>& boundaries, double time,
                 const Index<D>& node) {
    const auto cells = [&](double x) { return x / layout.cell_size + 1.0; };
    for (std::size_t axis = 0; axis < D; ++axis) {
        const auto& [near, far] = layout.mirrors[axis];
        if (near == Mirror::none && node[axis] <= 1) return true;
        if (far == Mirror::none && node[axis] >= layout.cells[axis] - 1) return true;
    }
    const Shelf& shelf = boundaries.shelf;
    if (shelf.exists() && node[0] <= cells(shelf.end_at(time)) && node[D - 1] <= cells(shelf.top))
        return true;
    if (boundaries.push.exists() && node[0] <= cells(boundaries.push.position(time)) + 1.0) return true;
    if (boundaries.piston.exists() && node[0] <= cells(boundaries.piston.position(time)) + 1.0) return true;
    return beside_bed(layout, boundaries.bed, node);
}

template <int D, class Real>
bool all_mirrors_and_water(const Simulation<D, Real>& s) {
    const Boundaries<D>& boundaries = s.parameters.boundaries;
    bool known = !boundaries.shelf.exists() && !boundaries.push.exists() && !boundaries.bed.exists() &&
                 !boundaries.piston.exists();
    for (const auto& axis : s.grid.layout.mirrors) {
        for (const Mirror mirror : axis) known = known && mirror != Mirror::none;
    }
    for (const auto& particles : s.bodies) known = known && particles.material == Material::water;
    return known;
}

// Marks the nodes of a block that the solids in block `slot` touch now, or a cell further on.
template <int D, class Real>
void mark_solids(const Simulation<D, Real>& s, std::size_t slot, const Index<D>& node_block,
                 std::uint8_t* marks) {
    constexpr int reach = 2, width = 2 * reach + 1;
    const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
    for (const auto& particles : s.bodies) {
        if (particles.material == Material::water) continue;
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            for (int k = 0; k < power(width, D); ++k) {
                int node = 0;
                for (std::size_t axis = 0; axis < D && node >= 0; ++axis) {
                    const int offset = k / power(width, D - 1 - static_cast<int>(axis)) % width - reach;
                    const int n = nearest_node(particles.position[axis][p]) + offset +
                                  (block[axis] - node_block[axis]) * Block<D>::width;
                    node = n < 0 || n >= Block<D>::width ? -1 : node * Block<D>::width + n;
                }
                if (node >= 0) marks[node] = 1;
            }
        }
    }
}

}  // namespace

template <int D, class Real>
bool has_water(const Simulation<D, Real>& s, std::size_t slot) {
    return std::ranges::any_of(s.bodies, [&](const auto& particles) {
        return particles.material == Material::water && particles.begin[slot] < particles.begin[slot + 1];
    });
}

template <int D, class Real>
void mark_unknown_fill(Simulation<D, Real>& s) {
    s.unknown_fill.clear();
    if (s.parameters.water.scheme == WaterScheme::paper || all_mirrors_and_water(s)) return;
    const Grid<D, Real>& grid = s.grid;
    s.unknown_fill.assign(grid.nodes.size(), 0);
    parallel_for(grid.node_blocks.size(), [&](std::size_t slot) {
        const auto& tiles = grid.tiles_of_node[slot];
        const auto wet = [&](int tile) { return tile >= 0 && has_water(s, static_cast<std::size_t>(tile)); };
        if (std::ranges::none_of(tiles, wet)) return;  // no water reads these nodes
        const Index<D> block = block_at<D>(grid.node_blocks[slot]);
        std::uint8_t* marks = s.unknown_fill.data() + slot * Block<D>::nodes;
        for (int n = 0; n < Block<D>::nodes; ++n) {
            marks[n] =
                beside_held(grid.layout, s.parameters.boundaries, s.time, node_at(grid.layout, block, n));
        }
        for (const int tile : tiles) {
            if (tile >= 0) mark_solids(s, static_cast<std::size_t>(tile), block, marks);
        }
    });
}

template <int D>
double crowding_rate(const Parameters<D>& parameters, double cell_size, double dt) {
    if (parameters.water.scheme == WaterScheme::paper) return 0.0;
    return std::min(dt * std::sqrt(parameters.gravity / cell_size), greatest_rate);
}

template <int D, class Real>
void load_crowding(const Simulation<D, Real>& s, std::size_t slot, Node<Real>* tile) {
    constexpr int count = Surround<D>::count;
    constexpr Real unknown = std::numeric_limits<Real>::infinity();
    const Grid<D, Real>& grid = s.grid;
    const auto per_mass =
        static_cast<Real>(1.0 / (s.parameters.water.density * std::pow(grid.layout.cell_size, D)));
    alignas(64) Real e[count];
    for_each_run<D>([&](int to, int neighbour, int node, int length) {
        const auto block =
            static_cast<std::size_t>(grid.nodes_of_tile[slot][static_cast<std::size_t>(neighbour)]);
        const Node<Real>* nodes = grid.block_nodes(block) + node;
        for (int n = 0; n < length; ++n) e[to + n] = per_mass * nodes[n][mass_lane];
        if (s.unknown_fill.empty()) return;
        const std::uint8_t* marks =
            s.unknown_fill.data() + block * Block<D>::nodes + static_cast<std::size_t>(node);
        for (int n = 0; n < length; ++n) {
            if (marks[n]) e[to + n] = unknown;
        }
    });
    const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
    double_on_walls<D>(grid.layout, block, e);
    alignas(64) Real water[count];
    std::copy_n(e, count, water);
    add_bodies(s, block, e);
    fill_to_crowding<D>(water, e);
    reflect_in_walls<D>(grid.layout, block, e);
    smooth<D>(e);
    constexpr int tile_width = Block<D>::tile_width;
    for (int row = 0; row < power(tile_width, D - 1); ++row) {
        int from = 1;  // the tile begins one node inside
        for (int axis = 0; axis < D - 1; ++axis) {
            from += (row / power(tile_width, D - 2 - axis) % tile_width + 1) * stride_of<D>(axis);
        }
        for (int n = 0; n < tile_width; ++n) tile[row * tile_width + n][mass_lane] = e[from + n];
    }
}

#define TIDEWATER_INSTANTIATE(D, Real)                                \
    template bool has_water(const Simulation<D, Real>&, std::size_t); \
    template void mark_unknown_fill(Simulation<D, Real>&);            \
    template void load_crowding(const Simulation<D, Real>&, std::size_t, Node<Real>*);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)
template double crowding_rate<2>(const Parameters<2>&, double, double);
template double crowding_rate<3>(const Parameters<3>&, double, double);

}  // namespace tidewater::mpm
