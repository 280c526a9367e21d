// Water that leaves the scene, and the account of it. Who takes it: mpm/step/outlet.h, mpm/step/skim.h.
#pragma once

#include <cstddef>
#include <vector>

#include "mpm/particles/particles.h"

namespace tidewater::mpm {

// All that has left since the start.
template <int D>
struct Outflow {
    double mass = 0.0;                                       // kg
    Vector<D, double> momentum = Vector<D, double>::Zero();  // kg m/s
    double energy = 0.0;                                     // J, kinetic, gravitational and elastic
};

template <int D, class Real>
struct Simulation;

// Removes these particles (places in the body, rising) and adds them to s.outflow. The nodes keep their
// velocities; blocks may stay without particles until they are sorted.
template <int D, class Real>
void let_out(const std::vector<std::size_t>& gone, Particles<D, Real>& body, Simulation<D, Real>& s);

}  // namespace tidewater::mpm
