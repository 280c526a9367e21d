#include "mpm/boundaries/sponge.h"

namespace tidewater::mpm {

double Sponge::damping(double x) const {
    if (!exists() || x <= from) return 0.0;
    const double share = (x - from) / width;
    return rate * share * share;
}

template <int D, class Real>
WallAction<D> apply_sponge(const Layout<D>& layout, const Sponge& sponge, double dt, const Index<D>& block,
                           Node<Real>* nodes) {
    WallAction<D> action;
    const double end = layout.cell_size * (layout.first_node(block[0]) + Block<D>::width);
    if (!sponge.exists() || end <= sponge.from) return action;
    action.impulse = change_nodes<D, Real>(layout, block, nodes, [&](const Index<D>& at, Node<Real>& node) {
        const double kept = 1.0 / (1.0 + dt * sponge.damping(layout.cell_size * at[0]));
        const auto energy = [&] {
            return 0.5 * static_cast<double>(node[mass_lane]) *
                   node.template head<D>().template cast<double>().matrix().squaredNorm();
        };
        const double before = energy();
        node.template head<D>() *= static_cast<Real>(kept);
        action.work += energy() - before;
    });
    return action;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                     \
    template WallAction<D> apply_sponge<D, Real>(const Layout<D>&, const Sponge&, double, const Index<D>&, \
                                                 Node<Real>*);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
