// An outlet that keeps the water at its level: water that is above it near the right wall leaves the scene
// (Wolper et al. 2021, Fig. 3: "water particles exiting at the water tank outlet").
//
// Water whose particles are beyond x = from and above z = level leaves when particles are sorted next
// (mpm/step/drain.h); nodes notice nothing. What the outlet takes has to rise there: at q m²/s through a
// width b it needs a head of (q/b)²/2g, so b should not be much less than the depth. Crests that reach it are
// cut off.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

struct Outlet {
    double from = 0.0;   // m
    double level = 0.0;  // m; 0: no outlet

    bool exists() const { return level > 0.0; }

    template <int D>
    struct Acting {
        const Acting* on(const Index<D>&) const { return nullptr; }
        template <class Real>
        void act(const Index<D>&, Node<Real>&, WallAction<D>&) const {}
    };
    template <int D>
    Acting<D> acting(const Layout<D>&, const BoundaryStep&) const {
        return {};
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
