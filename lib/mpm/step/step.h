// The step that advances a simulation; mpm/step/step.cpp reads as the list of its stages.
//
//     sort        only when a particle might leave its block's margin; before it outlets and sponges take
//     water pass        nodes → particles (G2P), strain and position advance by dt, then particles → tiles
//     (P2G) with
//                 the forces of the coming step: all while a batch of particles is in the cache
//     nodes       tiles → nodes, momentum → velocity, gravity
//     contacts    rigid bodies against their nodes, walls and each other
//     boundaries  what holds, moves or damps nodes
//     restore     only where it is asked for: what the transfer will lose is given back
//     accounts    impulses and speeds
//
// Each stage is a parallel loop over blocks that write only their own data, and sums over blocks are taken in
// block order: any number of threads gives the same bits.
#pragma once

#include "mpm/state/simulation.h"
#include "mpm/step/time_step.h"

namespace tidewater::mpm {

// Advances by s.dt and gives the velocities the forces of a step of next_dt, which becomes s.dt. Forces may
// make something faster within a step than stable_time_step knew: only what would carry a particle beyond
// sorting_margin or turn its volume inside out is refused (max_motion in mpm/particles/motion.h). Throws
// NumericsError naming step, phase and particle when a value is not finite, a volume collapses (J ≤ 0), a
// particle leaves the box or moves half a cell in one step, its affine motion counted.
template <int D, class Real>
void advance(Simulation<D, Real>& simulation, double next_dt);

}  // namespace tidewater::mpm
