// Water before the right wall that takes the waves that enter it.
//
//     v ← v/(1 + σ Δt),   σ(x) = rate ((x − from)/width)²   for x > from
//
// and, if `level` is given, σ of what stands above the still level leaves in a second too (mpm/step/skim.h).
// Long waves, η = u √(D/g), then enter without an echo: both are damped alike. rate = 10 c/width, c = √(gD),
// is about the best. What comes back of a solitary wave of 0.2 D, crest and trough, stands in
// tests/validation/README.md: 3 % at most from a width of 6 D on. Without a level the wave's volume stays and
// flows back as a long, low wave: 58, 46 and 32 % from widths of 3, 5 and 10 D.
// Tests: tests/unit/mpm/flume_test.cpp, tests/validation/flume_test.cpp.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

struct Sponge {
    double from = 0.0;   // m
    double width = 0.0;  // m, up to the right wall; 0: no sponge
    double rate = 0.0;   // 1/s, σ at the wall
    double level = 0.0;  // m, of still water; 0: takes no water

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
        // Its work is the kinetic energy that the nodes lose, below zero.
        template <class Real>
        void act(const Index<D>& node, Node<Real>& of, WallAction<D>& action) const {
            const double kept = 1.0 / (1.0 + dt * sponge.damping(layout.cell_size * node[0]));
            const auto energy = [&] {
                return 0.5 * static_cast<double>(of[mass_lane]) *
                       of.template head<D>().template cast<double>().matrix().squaredNorm();
            };
            const double before = energy();
            of.template head<D>() *= static_cast<Real>(kept);
            action.work += energy() - before;
        }
    };
    template <int D>
    Acting<D> acting(const Layout<D>& layout, const BoundaryStep& step) const {
        return {layout, *this, step.dt};
    }

    bool replaces_left_wall() const { return false; }
    template <int D>
    bool hides_fill(const Layout<D>&) const {
        return false;
    }
    template <int D>
    bool hides_fill_at(const Layout<D>&, double, const Index<D>&) const {
        return false;
    }
};

}  // namespace tidewater::mpm
