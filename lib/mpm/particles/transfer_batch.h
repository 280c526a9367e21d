// Particle ↔ grid for a batch of particles: the formulas of mpm/particles/transfer.h, arranged for wide registers.
//
// A particle touches 3^D nodes; the three along the last axis lie side by side, 12 numbers (momentum and
// mass, or velocity) in one row of 16. With C of the middle node n as origin, offsets i, j, k ∈ {−1, 0, 1}
// per axis and weights w_i w_j w_k,
//
//     gather   v   = Σ w_i w_j w_k u_ijk
//              Δx C = 4 ( Σ w_i w_j w_k u_ijk (i, j, k)ᵀ − v fᵀ ),      f = x_p − x_n, cells
//     scatter  (m v)_ijk += w_i w_j w_k [ (P − G f) + G (i, j, k)ᵀ ],   m_ijk += w_i w_j w_k m
//
// with P the particle's momentum and G its gradient per cell. Rows are summed over i and j first, then the
// three quads of a row over k. Between particles everything is column by column (mpm/base/batch.h).
// Test: tests/unit/mpm/particles/transfer_batch_test.cpp (equal to mpm/particles/transfer.h to rounding).
#pragma once

#include "mpm/base/batch.h"
#include "mpm/particles/position.h"
#include "mpm/grid/stencil.h"

namespace tidewater::mpm {

// Nodes and weights of a batch of particles.
template <int D, class Real>
struct StencilBatch {
    Column<std::int32_t> first;   // tile index of the first node
    Column<std::int32_t> strip;   // of the first node, for scatter_batch
    Column<Real> from_node[D];    // f, cells
    Column<Real> weight[D][3];    // [axis][node]
    Column<Real> last_weight[4];  // the last axis' weights again, one quad per particle
};

// One batch between the grid and the particles' columns.
template <int D, class Real>
struct TransferBatch {
    StencilBatch<D, Real> stencil;
    Column<Real> vector[D];        // v, m/s; for scatter_batch P, kg m/s
    Column<Real> gradient[D * D];  // Δx C, row by row; for scatter_batch G
    Column<Real> scalar;           // Σ w of what the tile has in the mass lane
    Column<Real> quads[D + 1][4];  // scratch
};

// Positions (cells, −½ ≤ X < width + ½) → nodes and weights, for a whole batch.
template <int D, class Real>
void locate(const Column<Stored<Real>>* position, StencilBatch<D, Real>& stencil);

// Reads velocity, gradient and the scalar of a whole batch from a tile of Block<D>::tile_size nodes.
template <int D, class Real>
void gather_batch(const Real* tile, TransferBatch<D, Real>& batch);

// Velocities (m/s) and their gradients of a batch of particles, each of `mass` kg, as momenta for
// scatter_batch.
template <int D, class Real>
inline void velocity_to_momentum(Real mass, TransferBatch<D, Real>& batch) {
    for (auto& column : batch.vector) {
        for (int p = 0; p < batch_size; ++p) column[p] *= mass;
    }
    for (auto& column : batch.gradient) {
        for (int p = 0; p < batch_size; ++p) column[p] *= mass;
    }
}

// Where scatter_batch adds: for each row of nodes along the last axis and each node z at which a particle's
// three may begin, a strip of four nodes, z … z + 3, of which the last stays zero. Strips begin at cache
// lines, and two particles touch either the same strip or none in common: processors stall when they load
// what overlaps a store just made but is shifted against it, and take twice as long across cache lines.
template <int D>
inline constexpr int strip_count = power(Block<D>::tile_width, D - 1) * (Block<D>::width + 1);
template <int D, class Real>
struct alignas(64) Strips {
    Real value[strip_count<D> * 16];
};

// Adds momentum and mass of the first `count` particles, each of `mass` kg, to the strips; batch.vector and
// batch.quads are overwritten.
template <int D, class Real>
void scatter_batch(Real mass, int count, TransferBatch<D, Real>& batch, Strips<D, Real>& strips);

// Sums the strips into a tile, node by node in rising order of z.
template <int D, class Real>
void sum_strips(const Strips<D, Real>& strips, Real* tile);

}  // namespace tidewater::mpm
