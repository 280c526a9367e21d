// Walls as mirrors: what lies beyond a slip or stick wall is the image of what lies before it.
//
// About the plane W of a slip wall the velocity normal to it is odd and all else is even; about that of a
// stick wall all velocities are odd. A field that grows linearly from the plane is then exact up to it, and
// the walls are of second order. Particles less than half a cell from the plane touch one node beyond it,
// W ∓ 1, whose image is W ± 1:
//
//     fold     after P2G    m_image += m,  (m v)_image += S m v        nothing is left beyond
//     unfold   before G2P   v_beyond = S v_image
//     S        slip: −1 for the normal component, else 1; stick: −1 for all
//
// Both happen in the tile of a block, axis after axis, so that nodes beyond two or three walls go to the
// corner inside. Nodes on the plane and further beyond it follow mpm/boundaries/boundaries.h. The walls give
// the momentum
//
//     Σ (S − 1) m v   when folding,     Σ (S − 1) m v_image   when unfolding,     over nodes beyond,
//
// with m the mass before folding. Test: tests/unit/mpm/grid/mirror_test.cpp.
#pragma once

#include "mpm/grid/grid.h"

namespace tidewater::mpm {

// What is mirrored: the lanes of a node as velocity, or as numbers that are even about every wall.
enum class Parity { velocity, even };

// Calls visit(axis, far, mirror, plane, inward) for the walls that mirror, axis after axis: `far` is 0 for
// the wall at the origin and 1 for the opposite one, `plane` the number of the nodes on it, `inward` +1 or
// −1.
template <int D, class Visit>
void for_each_mirror(const Layout<D>& layout, const Visit& visit) {
    for (std::size_t axis = 0; axis < D; ++axis) {
        for (const std::size_t far : {std::size_t{0}, std::size_t{1}}) {
            const Mirror mirror = layout.mirrors[axis][far];
            if (mirror == Mirror::none) continue;
            visit(static_cast<int>(axis), far, mirror, far == 0 ? 0 : layout.cells[axis], far == 0 ? 1 : -1);
        }
    }
}

// Whether the tile of a block holds a mirror with the nodes on both sides of it.
template <int D>
bool has_mirror(const Layout<D>& layout, const Index<D>& block);

// Folds a tile of momenta and masses; returns the momentum (kg m/s) that the walls gave. A folded node of
// parity `velocity` keeps its mass in folded_mass_lane for unfolding_impulse; as it has none in the mass
// lane, momentum_to_velocity clears it.
template <int D, class Real>
Vector<D, double> fold(const Layout<D>& layout, const Index<D>& block, Parity parity, Node<Real>* tile);

// Fills the nodes beyond mirrors in a tile of velocities.
template <int D, class Real>
void unfold(const Layout<D>& layout, const Index<D>& block, Parity parity, Node<Real>* tile);

// Copies the velocities around particle block `slot` into `tile`, of Block<D>::tile_size nodes, as its
// particles read them.
template <int D, class Real>
void load_velocities(const Grid<D, Real>& grid, std::size_t slot, Node<Real>* tile);

// The momentum (kg m/s) that the walls give to the particles that read an unfolded tile.
//     folded      what fold left of the block's momenta; its kept masses are cleared
//     velocities  the unfolded tile
template <int D, class Real>
Vector<D, double> unfolding_impulse(const Layout<D>& layout, const Index<D>& block,
                                    const Node<Real>* velocities, Node<Real>* folded);

}  // namespace tidewater::mpm
