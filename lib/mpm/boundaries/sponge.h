// Water before the right wall that takes the waves that enter it.
//
//     v ← v/(1 + σ Δt),   σ(x) = rate ((x − from)/width)²   for x > from
//
// and, if `level` is given, σ of what stands above the still level leaves in a second too (mpm/step/skim.h). Long
// waves, η = u √(D/g), then enter without an echo: both are damped alike. rate = 10 c/width, c = √(gD), is
// about the best. What comes back of a solitary wave of 0.2 D, crest and trough, stands in
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
    double damping(double x) const;  // σ, 1/s
};

// Applies it to one block of nodes over a step of dt; `block` as block_at gives it. Its work is the kinetic
// energy that the nodes lose, below zero.
template <int D, class Real>
WallAction<D> apply_sponge(const Layout<D>& layout, const Sponge& sponge, double dt, const Index<D>& block,
                           Node<Real>* nodes);

}  // namespace tidewater::mpm
