// A transfer that loses less: the nodes' velocities get back what the particles' averaging takes from them.
//
// Between two steps velocities go from the nodes to the particles and back, and APIC's round trip P loses
// what particles cannot hold: in every step the share 0.024 (kΔx)⁴ of a wave of wavenumber k. With
//
//     v ← v + (v − P v),     (P v)_i = Σ_p w_ip m_p [ v_p + C_p (x_i − x_p) ] / m_i
//
// on the nodes after every grid update, the next trip leaves P (2 − P) v = (1 − (1 − P)²) v: the loss is
// squared. P is symmetric in the nodes' masses with eigenvalues from 0 to 1, so nothing grows, and it
// conserves momentum and angular momentum. It costs a second round trip, which takes about as long as a step
// of water. The driver resolves the bodies' contacts and applies the boundaries once more afterwards.
//
// Source: the second-order member of the family XPIC(m), Hammerquist & Nairn (2017), here with APIC's P and
// without velocities on particles.
// Test: tests/unit/mpm/step/restore_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Gives the nodes' velocities back what the coming round trip would take.
//     bodies        reads places and masses
//     grid          reads the nodes' masses; reads and writes their velocities
//     wall_impulse  adds the momentum that the nodes get, kg m/s, which can only come from walls
template <int D, class Real>
void restore_velocities(const std::vector<Particles<D, Real>>& bodies, Grid<D, Real>& grid,
                        Vector<D, double>& wall_impulse);

}  // namespace tidewater::mpm
