// How long the next step may be.
//
//     Δt ≤ cfl Δx/(c + v)           c: max. sound speed of all materials
//     v Δt + g Δt² ≤ 0.4 Δx         v: max. speed of nodes and rigid bodies
//
// The second limit keeps what moves and falls within the sorting margin. An isolated particle is stable for
// cfl < 0.71 in 2D and 0.58 in 3D (lib/mpm/README.md, Time step).
//
// Test: tests/unit/mpm/step/step_test.cpp.
#pragma once

#include "mpm/materials/material.h"
#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The longest step that meets both limits, s. It is infinite only without gravity, sound and motion.
template <int D, class Real>
double stable_time_step(const Simulation<D, Real>& simulation);

// The maximum sound speed of the materials of these bodies, m/s; 0 without any.
//     findings  what the last pass found in the particles' states
template <int D, class Real>
double max_sound_speed(const Parameters<D>& parameters, const std::vector<Particles<D, Real>>& bodies,
                       const Findings& findings);

}  // namespace tidewater::mpm
