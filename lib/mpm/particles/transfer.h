// The transfers particle → grid (P2G) and grid → particle (G2P) on one tile: MLS-MPM with APIC.
//
//     P2G   m_i     = Σ_p w_ip m_p
//           (m v)_i = Σ_p w_ip [ m_p v_p + (m_p C_p − Δt V0_p (4/Δx²) τ_p) (x_i − x_p) ]
//     G2P   v_p     = Σ_i w_ip v_i
//           C_p     = (4/Δx²) Σ_i w_ip v_i (x_i − x_p)ᵀ
//
// They conserve linear and angular momentum for any particle positions; the angular momentum of a particle is
// m (x × v) + m (Δx²/4) ε:Cᵀ. This is the plain form, which serves for starts and for readings of a state.
// The steps of water and ice use mpm/particles/transfer_batch.h.
//
// Sources: Jiang et al. (2015) for APIC, Hu et al. (2018) for MLS-MPM; lib/mpm/README.md, Grid and transfer.
// Test: tests/unit/mpm/particles/transfer_test.cpp.
#pragma once

#include "mpm/grid/stencil.h"

namespace tidewater::mpm {

// How velocities are transferred from the nodes to the particles and back: by APIC, or by APIC with its loss
// restored (mpm/step/restore.h).
enum class Transfer { apic, restored };

// Adds one particle to its tile of momenta and masses.
//     position   cells, relative to the tile's block
//     momentum   m v, kg m/s
//     gradient   change of momentum per cell of distance, Δx m C − Δt V0 (4/Δx) τ, kg m/s
template <int D, class Real>
inline void scatter(const Vector<D, double>& position, Real mass, const Vector<D, Real>& momentum,
                    const Matrix<D, Real>& gradient, Node<Real>* tile) {
    for_each_node<D, Real>(position, [&](int node, Real weight, const Vector<D, Real>& distance) {
        tile[node].template head<D>() += weight * (momentum + gradient * distance).array();
        tile[node][mass_lane] += weight * mass;
    });
}

// Gathers one particle's velocity (m/s) and its gradient per cell, Δx C (m/s), from its tile of velocities.
template <int D, class Real>
inline void gather(const Vector<D, double>& position, const Node<Real>* tile, Vector<D, Real>& velocity,
                   Matrix<D, Real>& gradient) {
    velocity.setZero();
    gradient.setZero();
    for_each_node<D, Real>(position, [&](int node, Real weight, const Vector<D, Real>& distance) {
        const Vector<D, Real> weighted = weight * tile[node].template head<D>().matrix();
        velocity += weighted;
        gradient += Real(4) * weighted * distance.transpose();
    });
}

}  // namespace tidewater::mpm
