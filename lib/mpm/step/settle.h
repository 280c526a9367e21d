// The settle phase: a scene that starts out of balance, for instance a slab without stress, finds its balance
// before time begins, elastically and without waves that would break the ice.
//
// The method is kinetic damping (Cundall 1976; Barnes 1988, dynamic relaxation), which needs no rate: the
// scene moves freely until the kinetic energy of its ice starts to fall, and then everything is stopped. In a
// scene without ice the energy of all particles decides. Meanwhile s.time stays 0, ice does not fail, nothing
// pushes, and rigid bodies are held in place; they are released with the velocity of their start when time
// begins.
//
// The phase ends when waves as strong as the remaining ones are no danger: when ρ c v ≤ tolerance at three
// peaks of the energy in a row, with v the root mean square speed of the ice.
//
// Test: tests/unit/mpm/step/settle_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Begins the phase, at s.time = 0.
template <int D, class Real>
void begin_settling(Simulation<D, Real>& s);

// Makes one step of the phase, and returns whether the phase is over by the tolerance (Pa). Then everything
// is at rest at s.time = 0, s.step = 0 and s.dt = 0, and accounts and impulses start from zero.
template <int D, class Real>
bool settle_step(Simulation<D, Real>& s, double tolerance);

}  // namespace tidewater::mpm
