// Particle → grid and grid → particle on one tile: MLS-MPM with APIC.
//
//     P2G   m_i     = Σ_p w_ip m_p
//           (m v)_i = Σ_p w_ip [ m_p v_p + (m_p C_p − Δt V0_p (4/Δx²) τ_p) (x_i − x_p) ]
//     G2P   v_p     = Σ_i w_ip v_i
//           C_p     = (4/Δx²) Σ_i w_ip v_i (x_i − x_p)ᵀ
//
// Linear and angular momentum are conserved for any particle positions, with a particle's angular momentum
// being m (x × v) + m (Δx²/4) ε:Cᵀ. Sources: Jiang et al. (2015) for APIC, Hu et al. (2018) for MLS-MPM;
// shared/physics.md §1. Test: tests/unit/mpm/transfer_test.cpp.
#pragma once

#include "mpm/stencil.h"

namespace tidewater::mpm {

// Adds one particle to its tile of momenta and masses.
//     position   in cells, relative to the tile's block
//     momentum   m v, kg m/s
//     gradient   momentum per cell of distance: Δx m C − Δt V0 (4/Δx) τ
//     tile       Block<D>::tile_nodes nodes
template <int D, class Real>
inline void scatter(const Vector<D, Real>& position, Real mass, const Vector<D, Real>& momentum,
                    const Matrix<D, Real>& gradient, Node<Real>* tile) {
    using S = Stencil<D, Real>;
    const S stencil(position);
    const auto lanes = [](const Vector<D, Real>& vector, Real last) {
        Node<Real> node = Node<Real>::Zero();
        node.template head<D>() = vector.array();
        node[mass_lane] = last;
        return node;
    };
    const Node<Real> along_x = lanes(gradient.col(0), Real(0));
    const Node<Real> along_y = D == 3 ? lanes(gradient.col(1), Real(0)) : Node<Real>::Zero();
    const Node<Real> along_z = lanes(gradient.col(D - 1), Real(0));
    const Node<Real> corner = lanes(momentum + gradient * stencil.to_first, mass);

    Node<Real>* node_x = tile + stencil.first;
    for (int i = 0; i < 3; ++i, node_x += S::stride_x) {
        for (int j = 0; j < S::layers; ++j) {
            const Real w = stencil.weight[0][static_cast<std::size_t>(i)] *
                           stencil.weight[1][static_cast<std::size_t>(j)];
            const Node<Real> row =
                w * (corner + static_cast<Real>(i) * along_x + static_cast<Real>(j) * along_y);
            const Node<Real> step = w * along_z;
            Node<Real>* node = node_x + j * S::stride_y;
            node[0] += stencil.weight[2][0] * row;
            node[1] += stencil.weight[2][1] * (row + step);
            node[2] += stencil.weight[2][2] * (row + (step + step));
        }
    }
}

// Reads one particle's velocity (m/s) and its gradient per cell, Δx C, from its tile of velocities.
template <int D, class Real>
inline void gather(const Vector<D, Real>& position, const Node<Real>* tile, Vector<D, Real>& velocity,
                   Matrix<D, Real>& gradient) {
    using S = Stencil<D, Real>;
    const S stencil(position);
    Node<Real> sum = Node<Real>::Zero(), sum_x = sum, sum_y = sum,
               sum_z = sum;  // Σ w v and Σ w v (node index)
    const Node<Real>* node_x = tile + stencil.first;
    for (int i = 0; i < 3; ++i, node_x += S::stride_x) {
        for (int j = 0; j < S::layers; ++j) {
            const Real w = stencil.weight[0][static_cast<std::size_t>(i)] *
                           stencil.weight[1][static_cast<std::size_t>(j)];
            const Node<Real>* node = node_x + j * S::stride_y;
            const Node<Real> middle = stencil.weight[2][1] * node[1];
            const Node<Real> last = stencil.weight[2][2] * node[2];
            const Node<Real> row = w * (stencil.weight[2][0] * node[0] + middle + last);
            sum += row;
            sum_x += static_cast<Real>(i) * row;
            if constexpr (D == 3) sum_y += static_cast<Real>(j) * row;
            sum_z += w * (middle + last + last);
        }
    }
    // Σ w v (x_i − x_p)ᵀ = Σ w v (node index)ᵀ + v (to_first)ᵀ, times 4.
    velocity = sum.template head<D>().matrix();
    gradient.col(0) = sum_x.template head<D>().matrix();
    if constexpr (D == 3) gradient.col(1) = sum_y.template head<D>().matrix();
    gradient.col(D - 1) = sum_z.template head<D>().matrix();
    gradient = Real(4) * (gradient + velocity * stencil.to_first.transpose());
}

}  // namespace tidewater::mpm
