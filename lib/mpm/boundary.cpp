#include "mpm/boundary.h"

#include <algorithm>

namespace tidewater::mpm {
namespace {

// The velocity at a wall of the given axis; `outward` is −1 at the origin's wall and +1 at the far one.
template <int D, class Real>
void apply_rule(WallRule rule, int axis, int outward, Node<Real>& velocity) {
    switch (rule) {
        case WallRule::stick:
            velocity.template head<D>().setZero();
            break;
        case WallRule::slip:
            velocity[axis] = Real(0);
            break;
        case WallRule::separate:
            velocity[axis] =
                outward < 0 ? std::max(velocity[axis], Real(0)) : std::min(velocity[axis], Real(0));
            break;
    }
}

// Walls that reach into the block: bit 2·axis for the origin's, 2·axis + 1 for the far one.
template <int D>
unsigned walls_in_block(const Layout<D>& layout, const Index<D>& block) {
    unsigned bits = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const int first = layout.first_node(block[axis]);
        if (first <= 0) bits |= 1u << (2 * axis);
        if (first + Block<D>::width > layout.cells[axis]) bits |= 2u << (2 * axis);
    }
    return bits;
}

}  // namespace

template <int D, class Real>
WallAction<D> apply_walls(const Layout<D>& layout, const Walls<D>& walls, const Index<D>& block,
                          Node<Real>* nodes) {
    WallAction<D> action;
    if (walls_in_block<D>(layout, block) == 0) return action;
    for (int n = 0; n < Block<D>::nodes; ++n) {
        Node<Real>& node = nodes[n];
        if (!(node[mass_lane] > Real(0))) continue;
        const Node<Real> before = node;
        for (int axis = D - 1, rest = n; axis >= 0; --axis, rest /= Block<D>::width) {
            const auto a = static_cast<std::size_t>(axis);
            const int index = layout.first_node(block[a]) + rest % Block<D>::width;
            if (index <= 0) apply_rule<D>(walls[a][0], axis, -1, node);
            if (index >= layout.cells[a]) apply_rule<D>(walls[a][1], axis, 1, node);
        }
        const Vector<D, double> from = before.template head<D>().template cast<double>().matrix();
        const Vector<D, double> to = node.template head<D>().template cast<double>().matrix();
        action.impulse += static_cast<double>(node[mass_lane]) * (to - from);
    }
    return action;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                              \
    template WallAction<D> apply_walls<D, Real>(const Layout<D>&, const Walls<D>&, const Index<D>&, \
                                                Node<Real>*);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
