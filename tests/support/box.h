// Runs of ice in a closed box that must stay sound whatever happens to the ice.
#pragma once

#include <doctest/doctest.h>

#include "support/energy.h"
#include "support/ice_body.h"

namespace tidewater::test {

// Real ice (E 1 GPa, βp0 0.5 MPa) and cells of 1 m, in a box of slip walls.
template <int D>
mpm::Start<D> ice_box(const mpm::Index<D>& cells, double gravity) {
    mpm::Start<D> start;
    start.cell_size = 1.0;
    start.cells = cells;
    start.parameters.gravity = gravity;
    return start;
}

// A box of that length along x and of `across` cells along all other axes.
template <int D>
mpm::Start<D> long_ice_box(int length, int across, double gravity = 0.0) {
    mpm::Index<D> cells;
    cells.fill(across);
    cells[0] = length;
    return ice_box<D>(cells, gravity);
}

// All particles are finite and in the box, to the half cell beyond a wall that mpm/boundaries/boundaries.h
// allows.
template <int D, class Real>
void check_in_box(const mpm::Simulation<D, Real>& s) {
    const auto state = read_state(s);
    CHECK(is_finite(state));
    long outside = 0;
    for (const auto& x : state.x) {
        for (int axis = 0; axis < D; ++axis) {
            const double cells = x[axis] / s.grid.layout.cell_size;
            const double last = s.grid.layout.cells[static_cast<std::size_t>(axis)];
            outside += !(cells > -0.5 && cells < last + 0.5);
        }
    }
    CHECK(outside == 0);
}

// Momentum is what it was `at_start` and what gravity and the walls gave since, to rounding of what moved
// (scale, kg m/s).
template <int D, class Real>
void check_momentum(const mpm::Simulation<D, Real>& s, const Vector<D, double>& at_start, double scale) {
    Vector<D, double> open = mpm::take_ledger(s).momentum - at_start - s.accounts.wall_impulse;
    open[D - 1] -= s.accounts.gravity_impulse;
    CHECK(open.norm() / scale < (sizeof(Real) == 4 ? 1e-5 : 1e-13));
}

// Σ m |v|, kg m/s.
template <int D, class Real>
double moving_mass(const mpm::Simulation<D, Real>& s) {
    const auto state = read_state(s);
    double sum = 0.0;
    for (std::size_t p = 0; p < state.x.size(); ++p) sum += state.mass[p] * state.v[p].norm();
    return sum;
}

// Goes on until a time, in s, and checks all that must hold for every ice in every state.
template <int D, class Real>
void check_run(double until, mpm::Simulation<D, Real>& s) {
    const Vector<D, double> given =
        s.accounts.wall_impulse + s.accounts.gravity_impulse * Vector<D, double>::Unit(D - 1);
    const Vector<D, double> momentum = mpm::take_ledger(s).momentum - given;
    const double moving = moving_mass(s);
    while (s.time < until) mpm::advance(s, mpm::stable_time_step(s));
    check_in_box(s);
    check_momentum(s, momentum,
                   moving + std::abs(s.accounts.gravity_impulse) + s.accounts.wall_impulse.norm());
}

// How many particles of a body are failed ice, as a share.
template <class Particles>
double failed_share(const Particles& particles) {
    double failed = 0.0;
    for (const auto alpha : particles.alpha) failed += alpha >= 0;
    return failed / static_cast<double>(particles.size());
}

// What TEST_CASE_TEMPLATE takes to run a case in 2D and 3D, float and double.
template <int Dimension, class RealType>
struct Engine {
    static constexpr int D = Dimension;
    using Real = RealType;
};
#define TIDEWATER_ENGINES \
    test::Engine<2, float>, test::Engine<2, double>, test::Engine<3, float>, test::Engine<3, double>

}  // namespace tidewater::test
