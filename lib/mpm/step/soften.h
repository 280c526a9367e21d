// The speed of sound of blocks in which a little water is far more compressed than what is around it.
//
// Water that is squeezed between ground and walls may keep three times the pressure around it, and with it
// the highest c of the scene: a hundred particles of half a million would set everybody's step. But they do
// not make it unstable. A mode v of the nodes has the frequency
//
//     ω² ≤ 4d/Δx² · Σ_p m_p c_p² |Δx C_p|²/Σ_p m_p |Δx C_p|²         (mpm/step/time_step.h)
//
// and C_p, which is gathered from the same nodes, is alike for particles near each other. What counts is
// therefore the mean of c² by mass over what shares nodes with a particle,
//
//     c̄_p² = Σ_i w_ip s_i,     s_i = Σ_q w_iq m_q c_q²/Σ_q w_iq m_q
//
// and a block's c becomes the largest c̄_p of its particles. Of a lone particle and of a crowd that is
// compressed as a whole it is their own c. Where a few stiff particles lie in soft ones, the mean is below
// the exact bound by what C varies over a cell; cfl has that reserve (mpm/step/time_step.h), and
// tests/unit/mpm/step/soften_test.cpp steps water with stiff grains without gain of energy.
//
// A mean costs some eight passes of a block. So they are taken only where c is above 1.02 of both the speed
// of sound of the ice there is and 1.1 of the water's at rest, and only while such blocks are at most a 32nd
// of all; else the block's c stays the max. of its particles.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Replaces the sound speeds of such blocks by those means, and tells how many blocks were changed.
//     grid, bodies  the particles where they are now
//     of_block      [particle block] c of its fastest material
template <int D, class Real>
std::size_t soften_signals(const Parameters<D>& parameters, const Grid<D, Real>& grid,
                           const std::vector<Particles<D, Real>>& bodies, std::vector<Signal>& of_block);

}  // namespace tidewater::mpm
