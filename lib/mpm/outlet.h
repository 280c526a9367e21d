// An outlet that keeps the water at its level: water that is above it near the right wall leaves the scene
// (Wolper et al. 2021, Fig. 3: "water particles exiting at the water tank outlet").
// Test: tests/unit/mpm/outlet_test.cpp.
#pragma once

#include "mpm/particles.h"

namespace tidewater::mpm {

// Water whose particles are beyond x = from and above z = level leaves when particles are sorted next. What
// the outlet takes has to rise there: at q m²/s through a width b it needs a head of (q/b)²/2g, so b should
// not be much less than the depth. Crests that reach it are cut off.
struct Outlet {
    double from = 0.0;   // m
    double level = 0.0;  // m; 0: no outlet

    bool exists() const { return level > 0.0; }
};

// All that has left since the start.
template <int D>
struct Outflow {
    double mass = 0.0;                                       // kg
    Vector<D, double> momentum = Vector<D, double>::Zero();  // kg m/s
    double energy = 0.0;                                     // J, kinetic, gravitational and elastic
};

template <int D, class Real>
struct Simulation;

// Removes the water that has passed the outlet, in order, and adds it to s.outflow. The nodes keep their
// velocities; blocks may stay without particles until they are sorted.
template <int D, class Real>
void drain(Simulation<D, Real>& s);

}  // namespace tidewater::mpm
