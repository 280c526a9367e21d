// An outlet that keeps the water at its level: water that is above it near the right wall leaves the scene
// (Wolper et al. 2021, Fig. 3: "water particles exiting at the water tank outlet").
// Test: tests/unit/mpm/step/outlet_test.cpp.
#pragma once

#include "mpm/step/outflow.h"

namespace tidewater::mpm {

// Water whose particles are beyond x = from and above z = level leaves when particles are sorted next. What
// the outlet takes has to rise there: at q m²/s through a width b it needs a head of (q/b)²/2g, so b should
// not be much less than the depth. Crests that reach it are cut off.
struct Outlet {
    double from = 0.0;   // m
    double level = 0.0;  // m; 0: no outlet

    bool exists() const { return level > 0.0; }
};

template <int D, class Real>
struct Simulation;

// Lets out the water that has passed the outlet (mpm/step/outflow.h).
template <int D, class Real>
void drain(Simulation<D, Real>& s);

}  // namespace tidewater::mpm
