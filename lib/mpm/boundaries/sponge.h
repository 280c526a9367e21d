// A sponge: water in front of the right wall that absorbs the waves that enter it.
//
//     v ← v/(1 + σ Δt),   σ(x) = rate ((x − from)/width)²   for x > from
//
// If `level` is given, the water above the still level is drained at the same rate σ (mpm/step/skim.h).
// Surface and velocity are then damped alike, and long waves, η = u √(D/g), enter without an echo. A rate of
// about 10 c/width, with c = √(gD), is best. Of a solitary wave of 0.2 D, crest and trough, 3 % at most come
// back from a width of 6 D on (tests/validation/README.md). Without a level the wave's volume stays and flows
// back as a long, low wave: 58, 46 and 32 % from widths of 3, 5 and 10 D.
//
// Tests: tests/unit/mpm/flume_test.cpp, tests/validation/flume_test.cpp.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

struct Sponge {
    double from = 0.0;   // m, x at which it begins
    double width = 0.0;  // m, up to the right wall; 0: no sponge
    double rate = 0.0;   // 1/s, σ at the wall
    double level = 0.0;  // m, of still water; 0: drains no water

    bool exists() const { return width > 0.0; }
    double damping(double x) const {  // σ, 1/s
        if (!exists() || x <= from) return 0.0;
        const double share = (x - from) / width;
        return rate * share * share;
    }

    template <int D>
    struct Acting {
        const Layout<D>& layout;
        const Sponge& sponge;
        double dt;  // s

        const Acting* on(const Index<D>& block) const {
            const double end = layout.cell_size * (layout.first_node(block[0]) + Block<D>::width);
            return sponge.exists() && end > sponge.from ? this : nullptr;
        }
        void narrow(const Index<D>& block, NodeBox<D>& box) const {
            box.narrow(block, 0, sponge.from / layout.cell_size, 1e9);
        }
        // The work is the change of the nodes' kinetic energy, which is never above zero.
        template <class Real>
        void act(const NodeAt<D>& at, Node<Real>& at_node, WallAction<D>& action) const {
            const double kept = 1.0 / (1.0 + dt * sponge.damping(layout.cell_size * at.node[0]));
            const double before = kinetic_energy_of<D>(at_node);
            at_node.template head<D>() *= static_cast<Real>(kept);
            action.work += kinetic_energy_of<D>(at_node) - before;
        }
    };
    template <int D>
    Acting<D> acting(const Layout<D>& layout, const BoundaryStep& step) const {
        return {layout, *this, step.dt};
    }
};

}  // namespace tidewater::mpm
