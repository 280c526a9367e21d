#include "mpm/particles/transfer_batch.h"

#include <cassert>

#include "mpm/base/instantiate.h"
#include "mpm/base/row.h"

namespace tidewater::mpm {
namespace {

// The place of particle p's quad. Within a group of 16 particles, quads are in the order in which a
// transposition within 128 bits leaves them: that of particle 4a + b is in place 4b + a.
int quad_place(int p) { return (p & ~15) | ((p & 3) << 2) | ((p >> 2) & 3); }

// Transposes four rows of quads (a0 b0 c0 d0 | …) into the rows (a0 a1 a2 a3 | …), (b0 b1 b2 b3 | …), … and
// back.
template <class Real>
void transpose(Row<Real>& a, Row<Real>& b, Row<Real>& c, Row<Real>& d) {
    using R = Row<Real>;
    const R ab_low = __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    const R ab_high =
        __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    const R cd_low = __builtin_shufflevector(c, d, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    const R cd_high =
        __builtin_shufflevector(c, d, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
    c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
}

template <class Real>
Row<Real> row_at(const Column<Real>& column, int p) {
    return load_row<Real>(column.value + p);
}

// Makes one quad (x, y, z, w) per particle from the columns that fill(p, row) loads.
template <class Real, class Fill>
void to_quads(Column<Real>* quads, const Fill& fill) {
    for (int p = 0; p < batch_size; p += lanes) {
        Row<Real> row[4] = {};
        fill(p, row);
        transpose<Real>(row[0], row[1], row[2], row[3]);
        for (int n = 0; n < 4; ++n) store(row[n], quads->value + 4 * p + lanes * n);
    }
}

// Copies the first D numbers of each quad to D columns, which lie `stride` columns apart, and the last number
// to `last` if that is not null.
template <int D, class Real>
void from_quads(const Column<Real>* quads, Column<Real>* columns, int stride, Column<Real>* last = nullptr) {
    for (int p = 0; p < batch_size; p += lanes) {
        Row<Real> row[4];
        for (int n = 0; n < 4; ++n) row[n] = load_row<Real>(quads->value + 4 * p + lanes * n);
        transpose<Real>(row[0], row[1], row[2], row[3]);
        for (int c = 0; c < D; ++c) store(row[c], columns[c * stride].value + p);
        if (last != nullptr) store(row[mass_lane], last->value + p);
    }
}

template <int D>
constexpr int stride_x = 4 * power(Block<D>::tile_width, D - 1);
template <int D>
constexpr int stride_y = 4 * Block<D>::tile_width;
template <int D>
constexpr int strips_in_row = Block<D>::width + 1;

// Sums over the nodes of one particle of w u and of w u times the node's offset along each axis.
template <int D, class Real>
struct NodeSums {
    Quad<Real> value, along[D];
};

template <int D, class Real>
NodeSums<D, Real> sum_nodes(const Real* node, const Real (&wx)[3], [[maybe_unused]] const Real (&wy)[3],
                            const Row<Real>& wz) {
    using R = Row<Real>;
    R total, along_x;
    [[maybe_unused]] R along_y;
    if constexpr (D == 2) {
        const R before = wx[0] * load_row<Real>(node);
        const R after = wx[2] * load_row<Real>(node + 2 * stride_x<D>);
        total = wx[1] * load_row<Real>(node + stride_x<D>) + (before + after);
        along_x = after - before;
    } else {
        R plane[3], tilt[3];  // sums over y of w u and of w u j
        for (int i = 0; i < 3; ++i, node += stride_x<D>) {
            const R before = wy[0] * load_row<Real>(node);
            const R after = wy[2] * load_row<Real>(node + 2 * stride_y<D>);
            plane[i] = wy[1] * load_row<Real>(node + stride_y<D>) + (before + after);
            tilt[i] = after - before;
        }
        const R before = wx[0] * plane[0];
        const R after = wx[2] * plane[2];
        total = wx[1] * plane[1] + (before + after);
        along_x = after - before;
        along_y = wz * (wx[1] * tilt[1] + (wx[0] * tilt[0] + wx[2] * tilt[2]));
    }
    total = wz * total;
    along_x = wz * along_x;
    const auto over_z = [](const R& row) {
        return (quad_of<0, Real>(row) + quad_of<2, Real>(row)) + quad_of<1, Real>(row);
    };
    NodeSums<D, Real> sums;
    sums.value = over_z(total);
    sums.along[0] = over_z(along_x);
    if constexpr (D == 3) sums.along[1] = over_z(along_y);
    sums.along[D - 1] = quad_of<2, Real>(total) - quad_of<0, Real>(total);
    return sums;
}

// Adds w[i] (middle + i gx), i = −1, 0, 1, to the three strips of one particle that lie side by side along x.
// The rows contain the weights along z already.
template <int D, class Real>
void add_to_strips(const Real (&w)[3], const Row<Real>& middle, const Row<Real>& gx, Real* strip) {
    constexpr int next = 16 * strips_in_row<D> * (D == 2 ? 1 : Block<D>::tile_width);
    const Row<Real> rows[3] = {middle - gx, middle, middle + gx};
    for (int i = 0; i < 3; ++i) store(w[i] * rows[i] + load_row<Real>(strip + i * next), strip + i * next);
}

}  // namespace

template <int D, class Real>
void locate(const Column<Stored<Real>>* position, StencilBatch<D, Real>& s) {
    for (int p = 0; p < batch_size; ++p) s.first[p] = s.strip[p] = 0;
    for (int axis = 0; axis < D; ++axis) {
        for (int p = 0; p < batch_size; ++p) {
            const std::int32_t node = nearest_node(position[axis][p]);
            assert(node >= 0 && node <= Block<D>::width);
            const Real f = from_node(position[axis][p], node);
            // The tile begins at node −1 and the stencil one node below the nearest node, so the index of the
            // stencil's first node in the tile equals the number of the nearest node.
            s.first[p] = s.first[p] * Block<D>::tile_width + node;
            s.strip[p] = s.strip[p] * (axis == D - 1 ? strips_in_row<D> : Block<D>::tile_width) + node;
            s.from_node[axis][p] = f;
            const SplineWeights<Real> weights = closed_spline_weights(f);
            s.weight[axis][0][p] = weights.below;
            s.weight[axis][1][p] = weights.at;
            s.weight[axis][2][p] = weights.above;
        }
    }
    to_quads(s.last_weight, [&](int p, Row<Real>* row) {
        for (int n = 0; n < 3; ++n) row[n] = row_at(s.weight[D - 1][n], p);
    });
}

template <int D, class Real>
void gather_batch(const Real* tile, TransferBatch<D, Real>& b) {
    const StencilBatch<D, Real>& s = b.stencil;
    const auto& wx = s.weight[0];
    const auto& wy = s.weight[D - 2];
    for (int p = 0; p < batch_size; ++p) {
        const int place = 4 * quad_place(p);
        const Row<Real> wz = spread<Real>(load_quad<Real>(s.last_weight->value + place));
        const auto sums = sum_nodes<D, Real>(tile + 4 * s.first[p], {wx[0][p], wx[1][p], wx[2][p]},
                                             {wy[0][p], wy[1][p], wy[2][p]}, wz);
        store(sums.value, b.quads[0]->value + place);
        for (int axis = 0; axis < D; ++axis) store(sums.along[axis], b.quads[axis + 1]->value + place);
    }
    from_quads<D>(b.quads[0], b.vector, 1, &b.scalar);
    for (int axis = 0; axis < D; ++axis) from_quads<D>(b.quads[axis + 1], b.gradient + axis, D);
    for (int c = 0; c < D; ++c) {
        for (int axis = 0; axis < D; ++axis) {
            Column<Real>& g = b.gradient[c * D + axis];
            for (int p = 0; p < batch_size; ++p)
                g[p] = Real(4) * (g[p] - b.vector[c][p] * s.from_node[axis][p]);
        }
    }
}

template <int D, class Real>
void scatter_batch(Real mass, int count, TransferBatch<D, Real>& b, Strips<D, Real>& strips) {
    using R = Row<Real>;
    constexpr int layers = D == 2 ? 1 : 3;  // along y
    const StencilBatch<D, Real>& s = b.stencil;
    for (int c = 0; c < D; ++c) {
        for (int axis = 0; axis < D; ++axis) {
            const Column<Real>& g = b.gradient[c * D + axis];
            for (int p = 0; p < batch_size; ++p) b.vector[c][p] -= g[p] * s.from_node[axis][p];
        }
    }
    to_quads(b.quads[0], [&](int p, R* row) {
        for (int c = 0; c < D; ++c) row[c] = row_at(b.vector[c], p);
        row[mass_lane] = row[mass_lane] + mass;
    });
    for (int axis = 0; axis < D; ++axis) {
        to_quads(b.quads[axis + 1], [&](int p, R* row) {
            for (int c = 0; c < D; ++c) row[c] = row_at(b.gradient[c * D + axis], p);
        });
    }
    const auto& wx = s.weight[0];
    const auto& wy = s.weight[D - 2];
    const R offset = {-1, -1, -1, -1, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0};  // k of each quad
    Column<Real> w[layers][3];  // weights of the particle's 3^(D−1) strips
    for (int layer = 0; layer < layers; ++layer) {
        for (int i = 0; i < 3; ++i) {
            for (int p = 0; p < batch_size; ++p) w[layer][i][p] = D == 2 ? wx[i][p] : wx[i][p] * wy[layer][p];
        }
    }
    for (int p = 0; p < count; ++p) {
        const int place = 4 * quad_place(p);
        const auto quad = [&](int n) { return repeat<Real>(load_quad<Real>(b.quads[n]->value + place)); };
        const R wz = spread<Real>(load_quad<Real>(s.last_weight->value + place));
        const R middle = wz * (offset * quad(D) + quad(0));
        const R gx = wz * quad(1);
        const auto add = [&](int layer, const R& row) {
            add_to_strips<D, Real>({w[layer][0][p], w[layer][1][p], w[layer][2][p]}, row, gx,
                                   strips.value + 16 * (s.strip[p] + layer * strips_in_row<D>));
        };
        if constexpr (D == 2) {
            add(0, middle);
        } else {
            const R gy = wz * quad(2);
            add(0, middle - gy);
            add(1, middle);
            add(2, middle + gy);
        }
    }
}

template <int D, class Real>
void sum_strips(const Strips<D, Real>& strips, Real* tile) {
    constexpr int rows = power(Block<D>::tile_width, D - 1);
    const Real* strip = strips.value;
    for (int row = 0; row < rows; ++row) {
        Quad<Real> ahead[2] = {};  // sums of the previous strips for this node and the next
        for (int z = 0; z < strips_in_row<D>; ++z, strip += 16, tile += 4) {
            store(ahead[0] + load_quad<Real>(strip), tile);
            ahead[0] = ahead[1] + load_quad<Real>(strip + 4);
            ahead[1] = load_quad<Real>(strip + 8);
        }
        store(ahead[0], tile);
        store(ahead[1], tile + 4);
        tile += 8;
    }
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                 \
    template void locate(const Column<Stored<Real>>*, StencilBatch<D, Real>&);         \
    template void gather_batch(const Real*, TransferBatch<D, Real>&);                  \
    template void scatter_batch(Real, int, TransferBatch<D, Real>&, Strips<D, Real>&); \
    template void sum_strips(const Strips<D, Real>&, Real*);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
