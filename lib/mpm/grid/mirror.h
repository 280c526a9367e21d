// Walls as mirrors: the fields beyond a slip or stick wall are the image of those inside.
//
// The normal velocity is odd about the plane W of a slip wall, and everything else is even; about the plane
// of a stick wall all velocities are odd. A field that grows linearly from the plane is then exact up to the
// plane, so these walls are of second order. Particles less than half a cell from the plane touch one node
// beyond it, W ∓ 1, whose image is W ± 1:
//
//     fold     after P2G    m_image += m,  (m v)_image += S m v        the node beyond is emptied
//     unfold   before G2P   v_beyond = S v_image
//     S        slip: −1 for the normal component, else 1; stick: −1 for all
//
// Both act in the tile of a block, axis after axis, so that a node beyond two or three walls is mirrored to
// the inner corner. Nodes on the plane and further beyond it follow mpm/boundaries/boundaries.h. The impulse
// of the walls, summed over the nodes beyond, is
//
//     Σ (S − 1) m v   for folding,     Σ (S − 1) m v_image   for unfolding,
//
// with m the mass of the node beyond before folding. Test: tests/unit/mpm/grid/mirror_test.cpp.
#pragma once

#include "mpm/grid/grid.h"

namespace tidewater::mpm {

// How the first D lanes of a node are mirrored: as a velocity, or as numbers that are even about every wall.
enum class Parity { velocity, even };

// Calls visit(axis, far, mirror, plane, inward) for the walls that mirror, axis after axis. `far` is 0 for
// the wall at the origin and 1 for the opposite one, `plane` is the number of the nodes on the wall, and
// `inward` is the direction into the box, +1 or −1.
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

// Whether the tile of a block contains a mirror and the nodes on both of its sides.
template <int D>
bool has_mirror(const Layout<D>& layout, const Index<D>& block);

// Folds a tile of momenta and masses and returns the impulse (kg m/s) of the walls. With parity `velocity` a
// folded node keeps its mass in folded_mass_lane for unfolding_impulse. momentum_to_velocity clears it later,
// because the mass lane of such a node is 0.
template <int D, class Real>
Vector<D, double> fold(const Layout<D>& layout, const Index<D>& block, Parity parity, Node<Real>* tile);

// Fills the nodes beyond the mirrors of a tile with the images of those inside.
template <int D, class Real>
void unfold(const Layout<D>& layout, const Index<D>& block, Parity parity, Node<Real>* tile);

// Copies the velocities around particle block `slot` into `tile`, which has Block<D>::tile_size nodes, and
// unfolds them: what the particles of the block gather from.
template <int D, class Real>
void load_velocities(const Grid<D, Real>& grid, std::size_t slot, Node<Real>* tile);

// The impulse (kg m/s) of the walls on the particles that gather from an unfolded tile.
//     folded      the tile of momenta after fold; the masses that it kept are cleared
//     velocities  the unfolded tile
template <int D, class Real>
Vector<D, double> unfolding_impulse(const Layout<D>& layout, const Index<D>& block,
                                    const Node<Real>* velocities, Node<Real>* folded);

}  // namespace tidewater::mpm
