// Water before the right wall that takes the waves that enter it.
//
//     v ← v/(1 + σ Δt),   σ(x) = rate ((x − from)/width)²   for x > from
//
// A long wave that runs through it to the wall and back is left with exp(−rate width/3c) of its height,
// c = √(gD). But the sponge takes momentum alone: the volume that a solitary wave brings stays and flows back
// as a long, low wave. Of a crest of 0.2 D (strength = rate width/c of 10) 58, 46 and 32 % return from widths
// of 3, 5 and 10 D. Test: tests/unit/mpm/flume_test.cpp.
#pragma once

#include "mpm/wall.h"

namespace tidewater::mpm {

struct Sponge {
    double from = 0.0;   // m
    double width = 0.0;  // m, up to the right wall; 0: no sponge
    double rate = 0.0;   // 1/s, σ at the wall

    bool exists() const { return width > 0.0; }
    double damping(double x) const;  // σ, 1/s
};

// Applies it to one block of nodes over a step of dt; `block` as block_at gives it. Its work is the kinetic
// energy that the nodes lose, below zero.
template <int D, class Real>
WallAction<D> apply_sponge(const Layout<D>& layout, const Sponge& sponge, double dt, const Index<D>& block,
                           Node<Real>* nodes);

}  // namespace tidewater::mpm
