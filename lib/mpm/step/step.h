// The step that advances a simulation. mpm/step/step.cpp reads as the list of its stages:
//
//     sort        particles into blocks, only when one might leave its block's margin; before that, outlets
//                 and sponges drain water (mpm/step/sort.h)
//     pass        nodes → particles (G2P), strain and position advance by dt, particles → tiles (P2G)
//                 with the forces there, all while a batch is in the cache (mpm/step/pass.h);
//                 then rigid bodies move by dt
//     nodes       tiles → nodes, momentum → velocity, gravity (mpm/step/nodes.h)
//     matter      which nodes are ice and which water, where a boundary tells them apart (mpm/step/matter.h)
//     contacts    rigid bodies with their nodes, walls and each other (mpm/step/contact.h)
//     drag        how much the ground slows each column of water (mpm/step/slow_columns.h)
//     boundaries  hold, move or damp nodes (mpm/step/nodes.h, mpm/boundaries/boundaries.h)
//     restore     gives back what the coming transfer will lose, then contacts and boundaries once more; only
//                 where Transfer::restored is chosen (mpm/step/restore.h)
//     accounts    impulses and speeds (mpm/step/nodes.h for those of mirrors)
//
// Each stage is a parallel loop over blocks that write only their own data, and sums over blocks are taken in
// block order: any number of threads gives the same bits.
//
// Tests: tests/unit/mpm/step/step_test.cpp, tests/unit/mpm/twin_test.cpp, tests/unit/mpm/invariance_test.cpp.
#pragma once

#include "mpm/state/simulation.h"
#include "mpm/step/time_step.h"

namespace tidewater::mpm {

// Advances particles and bodies by s.dt, gives the velocities the forces of (s.dt + next_dt)/2 (s), which
// take them from the middle of that step to the middle of the next, and sets s.dt to next_dt. Forces may make
// something faster within a step than stable_time_step could know. That is refused only where it would carry
// a particle beyond sorting_margin or turn its volume inside out (BlockMotion in mpm/particles/motion.h).
// Throws NumericsError, which names step, phase and particle, if a value is not finite, if a volume collapses
// (J ≤ 0), if a particle leaves the box, or if one moves by half a cell in a step, its affine motion
// included.
template <int D, class Real>
void advance(Simulation<D, Real>& simulation, double next_dt);

}  // namespace tidewater::mpm
