#include "mpm/boundaries/walls.h"

#include "mpm/base/instantiate.h"

namespace tidewater::mpm {

template <int D>
const typename Walls<D>::Acting* Walls<D>::Acting::on(const Index<D>& block) const {
    for (std::size_t axis = 0; axis < D; ++axis) {
        const int first = layout.first_node(block[axis]);
        if (first <= 0 || first + Block<D>::width > layout.cells[axis]) return this;
    }
    return nullptr;
}

template <int D>
void Walls<D>::Acting::narrow(const Index<D>& block, NodeBox<D>& box) const {
    int met = 0;
    NodeBox<D> at_wall = box;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const int first = layout.first_node(block[axis]), cells = layout.cells[axis];
        const bool near = first <= 0, far = first + Block<D>::width > cells;
        met += near + far;
        if (near) at_wall.narrow(block, axis, -1e9, 0.0);
        if (far) at_wall.narrow(block, axis, cells, 1e9);
    }
    if (met == 1) box = at_wall;
}

template <int D>
bool Walls<D>::hides_fill(const Layout<D>& layout) const {
    for (const auto& [near, far] : layout.mirrors) {
        if (near == Mirror::none || far == Mirror::none) return true;
    }
    return false;
}

template <int D>
bool Walls<D>::hides_fill_at(const Layout<D>& layout, double, const Index<D>& node) const {
    for (std::size_t axis = 0; axis < D; ++axis) {
        const auto& [near, far] = layout.mirrors[axis];
        if (near == Mirror::none && node[axis] <= 1) return true;
        if (far == Mirror::none && node[axis] >= layout.cells[axis] - 1) return true;
    }
    return false;
}

#define TIDEWATER_INSTANTIATE(D) template struct Walls<D>;
TIDEWATER_FOR_EACH_DIMENSION(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
