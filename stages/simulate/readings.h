// What the tables tell of the moments at which rows are due: readings of the states around such a moment, and
// the reading between them.
//
// A state holds places of its `time` and velocities, with what acted on them, of its `motion_time` half a
// step later (mpm/state/simulation.h). A reading between two states takes both at the row's own time, each
// linearly by its own distance: (1 − a) y1 + a y2. What balances in states therefore balances in rows to
// rounding, and no row changes a step.
//
// Test: tests/unit/simulate/readings_test.cpp.
#pragma once

#include <vector>

#include "analysis/surface.h"
#include "mpm/state/ledger.h"

namespace tidewater {

// A rigid block.
struct BodyReading {
    // Of the time.
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  // m, in the box
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    // Of the motion's time; impulses since the start, as in mpm/bodies/rigid.h.
    Eigen::Vector3d velocity, angular_velocity;
    Eigen::Vector3d water_impulse, water_angular_impulse, contact_impulse;
    double fastest = 0.0;  // m/s, of its corners
    double kinetic = 0.0;  // J
    double mass = 0.0;     // kg
};

template <int D>
struct Reading {
    double time = 0.0, motion_time = 0.0;  // s
    long step = 0;
    std::vector<double> surface;   // [gauge] m above still water; NaN: dry
    std::vector<double> pressure;  // [pressure gauge] Pa
    std::vector<BodyReading> bodies;
    mpm::Ledger<D> ledger;
    mpm::Accounts<D> accounts;
};

// Where a scene reads water.
template <int D>
struct Instruments {
    analysis::Tank tank;
    std::vector<analysis::Place> gauges;
    std::vector<Vector<D, double>> sensors;  // of the pressure, m
};

// Reads one state as it is.
template <int D, class Real>
Reading<D> read_state(const mpm::Simulation<D, Real>& simulation, const Instruments<D>& instruments);

// The reading at `time`, from those of two steps in a row with before.time ≤ time ≤ after.time. A gauge that
// is dry at one of them tells what the nearer one does. `step` is the number of steps done by then.
template <int D>
Reading<D> reading_between(const Reading<D>& before, const Reading<D>& after, double time);

}  // namespace tidewater
