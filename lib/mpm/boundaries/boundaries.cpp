#include "mpm/boundaries/boundaries.h"

#include "mpm/base/instantiate.h"

namespace tidewater::mpm {

template <int D>
Mirrors<D> mirrors_of(const Boundaries<D>& boundaries) {
    const bool replaced = replaces_left_wall(boundaries);
    Mirrors<D> mirrors{};
    for (std::size_t axis = 0; axis < D; ++axis) {
        for (std::size_t side = 0; side < 2; ++side) {
            if (axis == 0 && side == 0 && replaced) continue;
            const WallRule rule = boundaries.walls[axis][side];
            if (rule == WallRule::slip) mirrors[axis][side] = Mirror::slip;
            if (rule == WallRule::stick) mirrors[axis][side] = Mirror::stick;
        }
    }
    return mirrors;
}

template <int D>
bool tells_matter(const ActingBoundaries<D>& acting, const Index<D>& block) {
    bool tells = false;
    const auto ask = [&](const auto& boundary) {
        if constexpr (requires { boundary.tells_matter(block); })
            tells = tells || boundary.tells_matter(block);
    };
    std::apply([&](const auto&... boundary) { (ask(boundary), ...); }, acting);
    return tells;
}

template <int D, class Real>
WallAction<D> apply_boundaries(const Layout<D>& layout, const ActingBoundaries<D>& acting,
                               const Index<D>& block, const BlockMatter<Real>& matter, float* grip,
                               Node<Real>* nodes, const NodeBox<D>& box) {
    WallAction<D> all;
    const auto apply = [&](const auto& boundary) {
        const auto here = boundary.on(block);
        if (!here) return;
        NodeBox<D> own = box;
        if constexpr (requires { here->narrow(block, own); }) here->narrow(block, own);
        WallAction<D> action;
        action.impulse = change_nodes<D, Real>(own, nodes, [&](int n, Node<Real>& velocity) {
            const NodeAt<D> at{.node = node_at(layout, block, n),
                               .matter = matter.of(n, velocity),
                               .grip = grip == nullptr ? nullptr : grip + n};
            here->act(at, velocity, action);
        });
        if constexpr (requires { boundary.account(action); }) boundary.account(action);
        all.add(action);
    };
    std::apply([&](const auto&... boundary) { (apply(boundary), ...); }, acting);
    return all;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                  \
    template WallAction<D> apply_boundaries<D, Real>(const Layout<D>&, const ActingBoundaries<D>&,      \
                                                     const Index<D>&, const BlockMatter<Real>&, float*, \
                                                     Node<Real>*, const NodeBox<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)
template bool tells_matter<2>(const ActingBoundaries<2>&, const Index<2>&);
template bool tells_matter<3>(const ActingBoundaries<3>&, const Index<3>&);
template Mirrors<2> mirrors_of(const Boundaries<2>&);
template Mirrors<3> mirrors_of(const Boundaries<3>&);

}  // namespace tidewater::mpm
