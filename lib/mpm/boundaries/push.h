// A plane that starts from the left wall at time 0 and pushes what is in front of it.
//
// Nodes behind the plane, and the first one in front of it, move along x at least as fast as the plane; it
// holds nothing back. It takes the place of the left wall. Its speed is
//
//     v(t) = speed (1 − cos(πt/ramp))/2      for 0 < t < ramp, then v = speed
//
// Test: tests/unit/mpm/boundaries/boundaries_test.cpp.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

struct Push {
    double speed = 0.0;  // m/s; 0: no plane
    double ramp = 0.0;   // s, until it has its full speed

    bool exists() const { return speed != 0.0; }
    double velocity(double time) const;  // m/s; 0 before time 0
    double position(double time) const;  // m

    template <int D>
    struct Acting {
        const Layout<D>& layout;
        bool exists;
        int last = 0;           // nodes up to this number along x are pushed
        double velocity = 0.0;  // m/s

        const Acting* on(const Index<D>& block) const {
            return exists && layout.first_node(block[0]) <= last ? this : nullptr;
        }
        template <class Real>
        void act(const NodeAt<D>& at, Node<Real>& at_node, WallAction<D>& action) const {
            if (at.node[0] > last) return;
            const auto pushed = std::max(at_node[0], static_cast<Real>(velocity));
            const auto gain = static_cast<double>(pushed - at_node[0]);
            action.work += static_cast<double>(at_node[mass_lane]) * gain * velocity;
            at_node[0] = pushed;
        }
    };
    template <int D>
    Acting<D> acting(const Layout<D>& layout, const BoundaryStep& step) const {
        // It pushes one node in front of the plane too: otherwise a body coasts while the plane is between
        // two nodes.
        return {layout, exists(),
                node_at_or_before(step.time ? position(*step.time) : 0.0, layout.cell_size) + 1,
                step.time ? velocity(*step.time) : 0.0};
    }

    bool replaces_left_wall() const { return exists(); }
    template <int D>
    bool hides_fill(const Layout<D>&) const {
        return exists();
    }
    template <int D>
    bool hides_fill_at(const Layout<D>& layout, double time, const Index<D>& node) const {
        return exists() && behind(node[0], position(time), 2.0, layout.cell_size);
    }
};

}  // namespace tidewater::mpm
