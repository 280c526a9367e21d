// The quadratic B-spline stencil and the tile of nodes around a block of cells.
//
// Space is divided into blocks of `width` cells per axis. Positions are in cells, relative to the first node
// of their block. Along each axis a particle touches the three nodes n − 1, n and n + 1 with n = ⌊X + ½⌋;
// their weights are those of core/spline.h at f = X − n ∈ [−½, ½).
//
// Particles at −½ ≤ X < width + ½ thus touch the nodes −1 … width + 1, the tile of the block. The margin of
// half a cell on each side needs no further nodes, and it lets particles move before they are sorted again.
#pragma once

#include <cassert>

#include "core/spline.h"
#include "core/types.h"
#include "mpm/base/index.h"

namespace tidewater::mpm {

template <int D>
struct Block {
    static constexpr int width = D == 2 ? 16 : 4;
    static constexpr int nodes = power(width, D);
    static constexpr int tile_width = width + 3;
    static constexpr int tile_nodes = power(tile_width, D);
    // In memory a tile has at least one spare node at its end, because kernels touch four nodes in a row
    // where a particle has three.
    static constexpr int tile_size = (tile_nodes + 4) / 4 * 4;
    static constexpr int neighbours = power(3, D);  // itself included
};

// Max. distance, in cells along any axis, that a particle may move after it was sorted: ½ less a reserve for
// rounding.
inline constexpr double sorting_margin = 0.49;

// Four numbers of a node. Lanes 0 … D − 1 are a vector: momentum before the nodes are updated, velocity
// afterwards. The special lanes below depend on where the node is stored:
//
//     nodes of the grid, tiles that particles are scattered to    mass_lane: mass
//     tiles of velocities that particles gather from              crowding_lane: see mpm/step/crowding.h
//     tile nodes beyond a mirror, after folding                   folded_mass_lane: the mass before folding
//                                                                 (mpm/grid/mirror.h)
template <class Real>
using Node = Eigen::Array<Real, 4, 1>;

inline constexpr int mass_lane = 3;
inline constexpr int crowding_lane = 3;
inline constexpr int folded_mass_lane = 0;

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
        const SplineWeights<Real> w = spline_weights(f[axis]);
        weight[axis][0] = w.below;
        weight[axis][1] = w.at;
        weight[axis][2] = w.above;
    }
    for (int n = 0; n < power(3, D); ++n) {
        int node = 0;
        Real w = 1;
        Vector<D, Real> distance;
        for (int axis = 0; axis < D; ++axis) {
            const int offset = neighbour_offset<D>(n, axis);
            node = node * Block<D>::tile_width + nearest[axis] + offset + 1;
            w *= weight[axis][offset + 1];
            distance[axis] = static_cast<Real>(offset) - f[axis];
        }
        visit(node, w, distance);
    }
}

}  // namespace tidewater::mpm
