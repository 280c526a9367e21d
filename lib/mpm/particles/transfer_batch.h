// The transfers of a batch of particles: the formulas of mpm/particles/transfer.h, arranged for wide
// registers.
//
// A particle touches 3^D nodes. The three along the last axis lie side by side: 12 numbers (momentum and
// mass, or velocity) in one row of 16. Let f be the particle's distance from the middle node x_n, let i, j, k
// ∈ {−1, 0, 1} be the offsets of a node from the middle one, and w_i w_j w_k its weight. Then
//
//     gather   v   = Σ w_i w_j w_k u_ijk
//              Δx C = 4 ( Σ w_i w_j w_k u_ijk (i, j, k)ᵀ − v fᵀ ),      f = x_p − x_n, cells
//     scatter  (m v)_ijk += w_i w_j w_k [ (P − G f) + G (i, j, k)ᵀ ],   m_ijk += w_i w_j w_k m
//
// where P is the particle's momentum and G its gradient per cell. Rows are summed over i and j first, then
// the three quads of the sum over k. All else works column by column (mpm/base/batch.h). Test:
// tests/unit/mpm/particles/transfer_batch_test.cpp, which finds the results of mpm/particles/transfer.h to
// rounding.
#pragma once

#include "mpm/base/batch.h"
#include "mpm/grid/stencil.h"
#include "mpm/particles/position.h"

namespace tidewater::mpm {

// The nodes and weights of a batch of particles.
template <int D, class Real>
struct StencilBatch {
    Column<std::int32_t> first;   // tile index of the first node
    Column<std::int32_t> strip;   // index of the strip that begins at the first node, for scatter_batch
    Column<Real> from_node[D];    // f, cells
    Column<Real> weight[D][3];    // [axis][node]
    Column<Real> last_weight[4];  // the weights of the last axis again, one quad per particle
};

// The working set of one batch in a transfer.
template <int D, class Real>
struct TransferBatch {
    StencilBatch<D, Real> stencil;
    Column<Real> vector[D];        // gather: v, m/s; scatter: P, kg m/s
    Column<Real> gradient[D * D];  // gather: Δx C, row by row; scatter: G
    Column<Real> scalar;           // gather: weighted sum of the crowding lane
    Column<Real> quads[D + 1][4];  // scratch
};

// Finds the nodes and weights of a whole batch from its positions (cells, −½ ≤ X < width + ½).
template <int D, class Real>
void locate(const Column<Stored<Real>>* position, StencilBatch<D, Real>& stencil);

// Gathers velocity, gradient and the scalar of a whole batch from a tile of Block<D>::tile_size nodes.
template <int D, class Real>
void gather_batch(const Real* tile, TransferBatch<D, Real>& batch);

// Turns the velocities (m/s) and gradients of a batch of particles, each of `mass` kg, into the momenta and
// gradients of scatter_batch.
template <int D, class Real>
inline void velocity_to_momentum(Real mass, TransferBatch<D, Real>& batch) {
    for (auto& column : batch.vector) {
        for (int p = 0; p < batch_size; ++p) column[p] *= mass;
    }
    for (auto& column : batch.gradient) {
        for (int p = 0; p < batch_size; ++p) column[p] *= mass;
    }
}

// What scatter_batch adds to: for each row of nodes along the last axis and each node z at which a particle's
// three nodes may begin, a strip of the four nodes z … z + 3, of which the last stays zero. Two particles add
// either to the same strip or to strips that do not overlap, since processors stall when a load overlaps a
// recent store at a shifted address. Strips begin at cache lines, because loads and stores across two lines
// take twice as long.
template <int D>
inline constexpr int strip_count = power(Block<D>::tile_width, D - 1) * (Block<D>::width + 1);
template <int D, class Real>
struct alignas(64) Strips {
    Real value[strip_count<D> * 16];
};

// Adds momentum and mass of the first `count` particles, each of `mass` kg, to the strips. Overwrites
// batch.vector and batch.quads.
template <int D, class Real>
void scatter_batch(Real mass, int count, TransferBatch<D, Real>& batch, Strips<D, Real>& strips);

// Sums the strips into a tile, node by node in ascending order of z.
template <int D, class Real>
void sum_strips(const Strips<D, Real>& strips, Real* tile);

}  // namespace tidewater::mpm
