// The walls of the box.
//
// A wall's rule (mpm/boundaries/wall.h) acts on the nodes on its plane and beyond it. Just beyond a wall that
// slips or sticks, velocities mirror those inside (mpm/grid/mirror.h), so that a particle slows down as it
// approaches the plane and does not pass it. A wall that separates does not mirror: a particle can come half
// a cell beyond it.
//
// Test: tests/unit/mpm/boundaries/boundaries_test.cpp.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

// [axis][0: at the origin, 1: at the far end]
template <int D>
struct Walls : std::array<std::array<WallRule, 2>, static_cast<std::size_t>(D)> {
    struct Acting {
        const Layout<D>& layout;
        const Walls& walls;
        bool left_wall_moves;

        const Acting* on(const Index<D>& block) const;
        // Of a block at one wall alone the nodes on it and beyond it; else all.
        void narrow(const Index<D>& block, NodeBox<D>& box) const;
        template <class Real>
        void act(const NodeAt<D>& at, Node<Real>& velocity, WallAction<D>&) const {
            for (std::size_t axis = 0; axis < D; ++axis) {
                const auto& [near, far] = walls[axis];
                const bool moves = axis == 0 && left_wall_moves;
                if (at.node[axis] <= 0 && !moves) apply_rule<D>(near, static_cast<int>(axis), -1, velocity);
                if (at.node[axis] >= layout.cells[axis])
                    apply_rule<D>(far, static_cast<int>(axis), 1, velocity);
            }
        }
    };
    Acting acting(const Layout<D>& layout, const BoundaryStep& step) const {
        return {layout, *this, step.left_wall_moves};
    }

    // Only walls that do not mirror hide how full the nodes on them are (mpm/step/crowding.h).
    bool hides_fill(const Layout<D>& layout) const;
    bool hides_fill_at(const Layout<D>& layout, double time, const Index<D>& node) const;
};

}  // namespace tidewater::mpm
