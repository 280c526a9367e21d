// The quadratic B-spline stencil and the tile of nodes around a block of cells.
//
// Space is cut into blocks of `width` cells per axis. Positions are in cells, relative to their block's first
// node. A particle touches three nodes per axis, so particles at −½ ≤ X < width + ½ touch the nodes −1 …
// width + 1: the block's tile. The half cell of margin on each side costs no node and lets particles move
// before they are sorted again.
//
//     weights of the nodes n − 1, n, n + 1 with n = ⌊X + ½⌋, f = X − n ∈ [−½, ½):
//     ½(½ − f)²,  ¾ − f²,  ½(½ + f)²
//
// Source: Jiang et al. (2016), "The material point method for simulating continuum materials", §7.
#pragma once

#include <array>
#include <cassert>

#include "core/types.h"

namespace tidewater::mpm {

constexpr int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

template <int D>
struct Block {
    static constexpr int width = D == 2 ? 16 : 4;
    static constexpr int nodes = power(width, D);
    static constexpr int tile_width = width + 3;
    static constexpr int tile_nodes = power(tile_width, D);
    // In memory a tile has at least one node after its last: kernels touch four nodes in a row where a
    // particle has three.
    static constexpr int tile_size = (tile_nodes + 4) / 4 * 4;
    static constexpr int neighbours = power(3, D);  // itself included
};

// How far, in cells and along any axis, a particle may move after it was sorted. Less than ½ by a rounding
// reserve.
inline constexpr double sorting_margin = 0.49;

// A node: momentum (after the grid update, velocity) in lanes 0 … D−1, mass in lane 3.
template <class Real>
using Node = Eigen::Array<Real, 4, 1>;

inline constexpr int mass_lane = 3;

// Calls visit(tile index, weight, distance from the particle in cells) for the 3^D nodes of a particle.
//     position   cells, relative to its block, −½ ≤ X < width + ½
template <int D, class Real, class Visit>
inline void for_each_node(const Vector<D, double>& position, const Visit& visit) {
    int nearest[D];
    Real weight[D][3];
    Vector<D, Real> f;  // from the nearest node, in [−½, ½)
    for (int axis = 0; axis < D; ++axis) {
        nearest[axis] = static_cast<int>(position[axis] + 1.5) - 1;
        assert(nearest[axis] >= 0 && nearest[axis] <= Block<D>::width);
        f[axis] = static_cast<Real>(position[axis] - nearest[axis]);
        const Real below = Real(0.5) - f[axis], above = Real(0.5) + f[axis];
        weight[axis][0] = Real(0.5) * below * below;
        weight[axis][1] = Real(0.75) - f[axis] * f[axis];
        weight[axis][2] = Real(0.5) * above * above;
    }
    for (int n = 0; n < power(3, D); ++n) {
        int node = 0;
        Real w = 1;
        Vector<D, Real> distance;
        for (int axis = 0; axis < D; ++axis) {
            const int offset = n / power(3, D - 1 - axis) % 3 - 1;
            node = node * Block<D>::tile_width + nearest[axis] + offset + 1;
            w *= weight[axis][offset + 1];
            distance[axis] = static_cast<Real>(offset) - f[axis];
        }
        visit(node, w, distance);
    }
}

}  // namespace tidewater::mpm
