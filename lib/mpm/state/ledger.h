// The mass, momentum and energy of a state. Over a run (mpm/state/accounts.h),
//
//     momentum − gravity impulse − wall impulse + outflow            stays constant to rounding
//     kinetic + gravitational + elastic − work + outflow             decreases by the scheme's loss and by
//                                                                    what failing ice dissipates
//
// where work is that of pushes and pistons, less what a sponge's damping took, and those of friction and
// drag, which are negative.
//
// Momentum and kinetic energy are those of the state's `motion_time`, half a step after its `time`, to which
// the other two energies belong (mpm/state/simulation.h). Of one state the sum may therefore seem to grow by
// the kinetic energy's change in half a step; rows of a run take each from two states at their own time
// (stages/simulate/readings.h).
//
// Energies are in J (per metre of width in 2D). Kinetic energy is ½ m (|v|² + (Δx²/4)|C|²), which includes
// the part that APIC keeps in C. Gravitational energy is m g z, from z = 0. Sums are in double, particle by
// particle within blocks and blocks in order. Test: tests/unit/mpm/step/step_test.cpp.
#pragma once

#include "mpm/particles/motion.h"
#include "mpm/state/simulation.h"

namespace tidewater::mpm {

template <int D>
struct Ledger {
    double mass = 0.0;                                       // kg
    Vector<D, double> momentum = Vector<D, double>::Zero();  // kg m/s
    double kinetic = 0.0;                                    // J
    double gravitational = 0.0;                              // J
    double elastic = 0.0;                                    // J
};

// The contribution of the particles first … end − 1 of a block, with velocities gathered from `tile`, the
// nodes around it.
template <int D, class Real>
Ledger<D> ledger_of(const Parameters<D>& parameters, const Layout<D>& layout,
                    const Particles<D, Real>& particles, const Index<D>& block, std::size_t first,
                    std::size_t end, const Tile<D, Real>& tile);

// The sum over all particles and rigid bodies.
template <int D, class Real>
Ledger<D> take_ledger(const Simulation<D, Real>& simulation);

}  // namespace tidewater::mpm
