// The settle phase: a scene that starts out of balance, a slab without stress for instance, finds its balance
// before time begins, elastically and without waves that would break it.
//
// Kinetic damping (Cundall 1976; Barnes 1988, dynamic relaxation): the scene moves freely until the kinetic
// energy of its ice (of everything, without ice) falls again, and then everything is stopped. It needs no
// rate. Meanwhile s.time stays 0, ice does not fail, nothing pushes, and rigid bodies are held where they
// are; with their start's velocity they are let go when time begins.
//
// It ends when a wave as strong as what is left is no danger: at several peaks in a row ρ c v ≤ tolerance,
// with v the root mean square speed of the ice. Test: tests/unit/mpm/step/settle_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Begins the phase at the start, s.time = 0.
template <int D, class Real>
void begin_settling(Simulation<D, Real>& s);

// One step of it. True when the phase is over by the tolerance (Pa); then everything is at rest at s.time =
// 0, s.step = 0 and s.dt = 0, and the impulses count from here.
template <int D, class Real>
bool settle_step(Simulation<D, Real>& s, double tolerance);

}  // namespace tidewater::mpm
