// An outlet that keeps the water at its level: water above that level near the right wall leaves the scene
// (Wolper et al. 2021, Fig. 3: "water particles exiting at the water tank outlet").
//
// Particles of water beyond x = from and above z = level leave when particles are sorted next
// (mpm/step/drain.h); nodes are not changed. The outlet's water has to rise to the level first: a discharge
// of q (m²/s) through an outlet of width b needs a head of (q/b)²/2g, so b should not be much less than the
// depth. Crests that reach the outlet are cut off.
//
// Test: tests/unit/mpm/step/drain_test.cpp.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

struct Outlet {
    double from = 0.0;   // m, x at which it begins
    double level = 0.0;  // m; 0: no outlet

    bool exists() const { return level > 0.0; }

    template <int D>
    struct Acting {
        const Acting* on(const Index<D>&) const { return nullptr; }
        template <class Real>
        void act(const NodeAt<D>&, Node<Real>&, WallAction<D>&) const {}
    };
    template <int D>
    Acting<D> acting(const Layout<D>&, const BoundaryStep&) const {
        return {};
    }
};

}  // namespace tidewater::mpm
