// What a run has of each conserved thing, and where it came from or went.
//
//     momentum(t) = momentum(0) + gravity impulse + wall impulse − outflow      closes to rounding
//     kinetic + gravitational + elastic − boundary work + outflow               falls by the scheme's loss
//                                                                               and what failing ice takes
//     (boundary work: of pushes and pistons, less what a sponge's damping took)
//
// Velocities have the forces of the coming step already (mpm/state/simulation.h), so kinetic energy runs
// ahead of the others by its change in half a step: the sum may seem to grow by that much, and no more.
//
// Energies in J (per metre of width in 2D). Kinetic energy counts what APIC keeps in C: ½ m (|v|² +
// (Δx²/4)|C|²). Gravitational energy is m g z from z = 0. Sums in double, particle by particle within blocks,
// blocks in order. Test: tests/unit/mpm/step/step_test.cpp.
#pragma once

#include "mpm/particles/motion.h"
#include "mpm/state/simulation.h"

namespace tidewater::mpm {

template <int D>
struct Ledger {
    double mass = 0.0;
    Vector<D, double> momentum = Vector<D, double>::Zero();
    double kinetic = 0.0;
    double gravitational = 0.0;
    double elastic = 0.0;
};

// One particle's share; what moves is read from `tile`, the nodes around its block.
template <int D, class Real>
Ledger<D> particle_ledger(const Parameters<D>& parameters, const Layout<D>& layout,
                          const Particles<D, Real>& particles, const Index<D>& block, std::size_t p,
                          const Tile<D, Real>& tile);

template <int D, class Real>
Ledger<D> take_ledger(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
