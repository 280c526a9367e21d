// The quadratic B-spline stencil and the tile of nodes around a block of cells.
//
// Space is cut into blocks of `width` cells per axis. Positions are in cells, relative to their block's first
// node. A particle touches three nodes per axis, so particles at −½ ≤ X < width + ½ touch the nodes −1 …
// width + 1: the block's tile. The half cell of margin on each side costs no node and lets particles move
// before they are sorted again.
//
//     weights of the nodes b, b+1, b+2 with b = ⌊X − ½⌋, f = X − b ∈ [½, 3⁄2):
//     ½(3⁄2 − f)²,  ¾ − (f − 1)²,  ½(f − ½)²
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
    static constexpr int width = D == 2 ? 8 : 4;
    static constexpr int nodes = power(width, D);
    static constexpr int tile_width = width + 3;
    static constexpr int tile_nodes = power(tile_width, D);
    static constexpr int neighbours = power(3, D);  // itself included
};

// How far, in cells and along any axis, a particle may move after it was sorted. Less than ½ by a rounding
// reserve.
inline constexpr double sorting_margin = 0.49;

// A node: momentum (after the grid update, velocity) in lanes 0 … D−1, mass in lane 3.
template <class Real>
using Node = Eigen::Array<Real, 4, 1>;

inline constexpr int mass_lane = 3;

// The 3^D nodes of one particle. In 2D the middle axis has one layer of weight 1, so that 2D and 3D share
// their loops.
template <int D, class Real>
struct Stencil {
    static constexpr int layers = D == 3 ? 3 : 1;
    static constexpr int stride_x = power(Block<D>::tile_width, D - 1);
    static constexpr int stride_y = D == 3 ? Block<D>::tile_width : 0;

    int first = 0;                                // tile index of the first node
    Vector<D, Real> to_first;                     // from the particle to the first node, cells
    std::array<std::array<Real, 3>, 3> weight{};  // [x, y, z][node]

    explicit Stencil(const Vector<D, Real>& position) {
        weight[1][0] = Real(1);
        for (int axis = 0; axis < D; ++axis) {
            const int node =
                static_cast<int>(position[axis] + Real(0.5));  // in the tile, whose first node is −1
            const Real f = position[axis] - static_cast<Real>(node - 1);
            weight[static_cast<std::size_t>(axis == D - 1 ? 2 : axis)] = {
                Real(0.5) * (Real(1.5) - f) * (Real(1.5) - f), Real(0.75) - (f - Real(1)) * (f - Real(1)),
                Real(0.5) * (f - Real(0.5)) * (f - Real(0.5))};
            to_first[axis] = -f;
            first = first * Block<D>::tile_width + node;
        }
    }
};

}  // namespace tidewater::mpm
