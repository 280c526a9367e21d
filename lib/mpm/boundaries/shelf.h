// A shelf: ground that fills the box from the left wall to x = end and from the bottom to z = top, in 3D for
// all y.
//
// Its top is ground (mpm/boundaries/ground.h); along its front face everything slides and may part from it.
// Edges lie on cell edges. At each node the nearer of the two faces acts. At the edge both act, and the top
// holds only what presses down on it. The front of a
// shelf that retreats is drawn back under what lies on it, cell by cell, and leaves water or nothing behind.
//
// Test: tests/unit/mpm/boundaries/boundaries_test.cpp.
#pragma once

#include "core/spline.h"
#include "mpm/boundaries/ground.h"

namespace tidewater::mpm {

struct Shelf {
    double end = 0.0, top = 0.0;  // m, at time 0; end 0: no shelf
    GroundRule rule;
    double retreat = 0.0;  // m/s, speed of the end towards the left wall from time 0 on

    bool exists() const { return end > 0.0; }
    double end_at(double time) const { return end - retreat * std::max(time, 0.0); }  // m

    template <int D>
    struct Acting {
        const Layout<D>& layout;
        const Shelf& shelf;
        double dt;
        int last = 0, top = 0;  // nodes with x ≤ last and z ≤ top, counted in nodes, lie in the shelf

        const Acting* on(const Index<D>& block) const {
            const bool inside = shelf.exists() && layout.first_node(block[0]) <= last &&
                                layout.first_node(block[D - 1]) <= top;
            return inside ? this : nullptr;
        }
        void narrow(const Index<D>& block, NodeBox<D>& box) const {
            box.narrow(block, 0, -1e9, last);
            box.narrow(block, D - 1, -1e9, top);
        }
        bool tells_matter(const Index<D>& block) const {
            return shelf.rule.tells_matter() && on(block) != nullptr;
        }
        template <class Real>
        void act(const NodeAt<D>& at, Node<Real>& velocity, WallAction<D>& action) const {
            const int below_top = top - at.node[D - 1], behind_front = last - at.node[0];
            if (below_top < 0 || behind_front < 0) return;
            if (below_top <= behind_front)
                meet_top(below_top == behind_front, below_top, at, velocity, action);
            if (behind_front <= below_top) apply_rule<D>(WallRule::separate, 0, -1, velocity);
        }

    private:
        template <class Real>
        void meet_top(bool edge, int below, const NodeAt<D>& at, Node<Real>& velocity,
                      WallAction<D>& action) const {
            // The spline's values at a level top, shared among the node on it and the one below.
            constexpr double share[] = {6.0 / 7.0, 1.0 / 7.0};
            Footing<D> footing;
            footing.normal = Vector<D, double>::Unit(D - 1);
            footing.height = shelf.top;
            if (below < 2 && shelf.rule.ice.needs_area()) {
                footing.area = share[below] * std::pow(layout.cell_size, D - 1);
                footing.room = quadratic_spline_integral(-below) * std::pow(layout.cell_size, D);
            }
            GroundRule of_top = shelf.rule;
            if (edge) of_top.holds_down = false;
            meet_ground(of_top, footing, dt, at, velocity, action);
        }
    };
    template <int D>
    Acting<D> acting(const Layout<D>& layout, const BoundaryStep& step) const {
        return {layout, *this, step.dt, node_at_or_before(end_at(step.time.value_or(0.0)), layout.cell_size),
                node_at_or_before(top, layout.cell_size)};
    }

    bool tells_matter() const { return exists() && rule.tells_matter(); }
    template <int D>
    bool hides_fill(const Layout<D>&) const {
        return exists();
    }
    template <int D>
    bool hides_fill_at(const Layout<D>& layout, double time, const Index<D>& node) const {
        const double dx = layout.cell_size;
        return exists() && behind(node[0], end_at(time), 1.0, dx) && behind(node[D - 1], top, 1.0, dx);
    }
};

}  // namespace tidewater::mpm
