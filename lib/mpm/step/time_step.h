// How long the next step may be.
//
//     Δt ≤ cfl Δx/max_b (c_b + v_b)    over blocks of particles: c_b: max. sound speed of its materials, or a
//                                      mean where a little water is stiff (mpm/step/soften.h);
//                                      v_b: max. speed of the nodes that its particles may feel
//     v Δt + g Δt² ≤ 0.4 Δx            v: max. speed of all nodes and of rigid bodies
//
// A drop that flies fast and ice that is stiff elsewhere do not add up. A rigid body counts with its own
// speed and the max. c of all. The second limit keeps what moves and falls within the sorting margin. An
// isolated particle is stable for cfl < 0.71 in 2D and 0.58 in 3D (lib/mpm/README.md, Time step).
//
// Test: tests/unit/mpm/step/step_test.cpp.
#pragma once

#include "mpm/materials/material.h"
#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The longest step that meets both limits, s. It is infinite only without gravity, sound and motion.
template <int D, class Real>
double stable_time_step(const Simulation<D, Real>& simulation);

// Finds what the next step depends on, after the nodes have their velocities.
//     node_speed  [node block] max. |v|, m/s
//     of_block    [particle block] c of its fastest material
//     rigid       the fastest of them counts with the max. c
//     near_speed  written: [particle block] as in Simulation
// Returns the fastest signal; of equal ones that of the first block.
template <int D, class Real>
Signal find_signal(const Grid<D, Real>& grid, const std::vector<double>& node_speed,
                   const std::vector<Signal>& of_block, const std::vector<RigidBody>& rigid,
                   std::vector<double>& near_speed);

// The maximum sound speed of the materials of these bodies, and whose it is; 0 without any. It has no motion.
//     findings  what the last pass found in the particles' states
template <int D, class Real>
Signal fastest_sound(const Parameters<D>& parameters, const std::vector<Particles<D, Real>>& bodies,
                     const Findings& findings);

}  // namespace tidewater::mpm
