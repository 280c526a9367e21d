#include "mpm/grid/mirror.h"

#include "mpm/base/instantiate.h"

namespace tidewater::mpm {
namespace {

// A mirror in a tile: the numbers in the tile of the layers of nodes beyond it and of their images.
struct Pane {
    Mirror mirror;
    int axis, beyond, image;
};

// Calls visit(pane) for the mirrors in the tile of a block, axis after axis.
template <int D, class Visit>
void for_each_pane(const Layout<D>& layout, const Index<D>& block, const Visit& visit) {
    for_each_mirror(layout, [&](int axis, std::size_t, Mirror mirror, int node, int inward) {
        const int plane = node - layout.first_node(block[static_cast<std::size_t>(axis)]) + 1;
        if (plane < 1 || plane > Block<D>::tile_width - 2) return;
        visit(Pane{mirror, axis, plane - inward, plane + inward});
    });
}

// Calls visit(node beyond, its image) for all nodes of a tile in the layer just beyond one mirror.
template <int D, class Visit>
void for_each_pair(const Pane& pane, const Visit& visit) {
    const int stride = power(Block<D>::tile_width, D - 1 - pane.axis);
    for (int start = 0; start < Block<D>::tile_nodes; start += stride * Block<D>::tile_width) {
        for (int n = start; n < start + stride; ++n) {
            visit(n + pane.beyond * stride, n + pane.image * stride);
        }
    }
}

// The diagonal of S, as factors of a node's lanes.
template <class Real>
Node<Real> signs(const Pane& pane, Parity parity) {
    Node<Real> s = Node<Real>::Ones();
    if (parity == Parity::even) return s;
    if (pane.mirror == Mirror::stick) s.template head<mass_lane>() = Real(-1);
    s[pane.axis] = Real(-1);
    return s;
}

template <int D, class Real>
Vector<D, double> in_double(const Node<Real>& node) {
    return node.template head<D>().template cast<double>().matrix();
}

}  // namespace

template <int D>
bool has_mirror(const Layout<D>& layout, const Index<D>& block) {
    bool any = false;
    for_each_pane<D>(layout, block, [&](const Pane&) { any = true; });
    return any;
}

template <int D, class Real>
Vector<D, double> fold(const Layout<D>& layout, const Index<D>& block, Parity parity, Node<Real>* tile) {
    Vector<D, double> impulse = Vector<D, double>::Zero();
    for_each_pane<D>(layout, block, [&](const Pane& pane) {
        const Node<Real> sign = signs<Real>(pane, parity);
        for_each_pair<D>(pane, [&](int beyond, int image) {
            Node<Real>& from = tile[beyond];
            const Real mass = from[mass_lane];
            if (!(mass > Real(0))) return;  // also skips nodes that another mirror has emptied already
            const Node<Real> reflected = sign * from;
            tile[image] += reflected;
            impulse += in_double<D, Real>(reflected) - in_double<D, Real>(from);
            from.setZero();
            if (parity == Parity::velocity) from[folded_mass_lane] = mass;
        });
    });
    return impulse;
}

template <int D, class Real>
void unfold(const Layout<D>& layout, const Index<D>& block, Parity parity, Node<Real>* tile) {
    for_each_pane<D>(layout, block, [&](const Pane& pane) {
        const Node<Real> sign = signs<Real>(pane, parity);
        for_each_pair<D>(pane, [&](int beyond, int image) { tile[beyond] = sign * tile[image]; });
    });
}

template <int D, class Real>
void load_velocities(const Grid<D, Real>& grid, std::size_t slot, Node<Real>* tile) {
    load_tile(grid, grid.nodes, slot, tile);
    unfold<D, Real>(grid.layout, block_at<D>(grid.particle_blocks[slot]), Parity::velocity, tile);
}

template <int D, class Real>
Vector<D, double> unfolding_impulse(const Layout<D>& layout, const Index<D>& block,
                                    const Node<Real>* velocities, Node<Real>* folded) {
    Vector<D, double> impulse = Vector<D, double>::Zero();
    for_each_pane<D>(layout, block, [&](const Pane& pane) {
        for_each_pair<D>(pane, [&](int beyond, int image) {
            const auto mass = static_cast<double>(folded[beyond][folded_mass_lane]);
            impulse +=
                mass * (in_double<D, Real>(velocities[beyond]) - in_double<D, Real>(velocities[image]));
            folded[beyond][folded_mass_lane] =
                Real(0);  // at a corner the node lies beyond another mirror too and must not count twice
        });
    });
    return impulse;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                \
    template Vector<D, double> fold<D, Real>(const Layout<D>&, const Index<D>&, Parity, Node<Real>*); \
    template void unfold<D, Real>(const Layout<D>&, const Index<D>&, Parity, Node<Real>*);            \
    template void load_velocities(const Grid<D, Real>&, std::size_t, Node<Real>*);                    \
    template Vector<D, double> unfolding_impulse<D, Real>(const Layout<D>&, const Index<D>&,          \
                                                          const Node<Real>*, Node<Real>*);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)
template bool has_mirror<2>(const Layout<2>&, const Index<2>&);
template bool has_mirror<3>(const Layout<3>&, const Index<3>&);

}  // namespace tidewater::mpm
