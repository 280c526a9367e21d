// The energy that goes with the positions.
//
// Velocities run half a step behind and ahead of the positions (mpm/state/ledger.h): ½ m v_n · v_n+1 is the
// kinetic energy that goes with x_n, exactly so for a falling stone.
#pragma once

#include "mpm/state/ledger.h"
#include "mpm/step/step.h"
#include "support/state.h"

namespace tidewater::test {

// Kinetic energy between two states one step apart, J.
template <int D>
double kinetic_between(const State<D>& before, const State<D>& after, double cell_size) {
    double kinetic = 0.0;
    for (std::size_t p = 0; p < after.x.size(); ++p) {
        const double affine = 0.25 * cell_size * cell_size * before.c[p].cwiseProduct(after.c[p]).sum();
        kinetic += 0.5 * after.mass[p] * (before.v[p].dot(after.v[p]) + affine);
    }
    return kinetic;
}

// Advances by one step and returns the total energy at its end, J.
template <int D, class Real>
double advance_and_weigh(mpm::Simulation<D, Real>& s, double next_dt) {
    const auto before = read_state(s);
    mpm::advance(s, next_dt);
    const auto ledger = mpm::take_ledger(s);
    return kinetic_between(before, read_state(s), s.grid.layout.cell_size) + ledger.gravitational +
           ledger.elastic;
}

}  // namespace tidewater::test
