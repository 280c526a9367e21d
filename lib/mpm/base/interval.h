// The times of one step of the engine.
//
// Particles move through [begin, begin + dt] with the present velocities of the nodes. Then, at its end, the
// nodes get the forces that act from the middle of this step to the middle of the following one, which has
// the length next_dt (leapfrog).
#pragma once

namespace tidewater::mpm {

struct Interval {
    long step = 0;          // number of the steps before this one
    double begin = 0.0;     // s
    double dt = 0.0;        // s
    double next_dt = 0.0;   // s
    bool settling = false;  // before time begins: ice does not fail and no boundary moves

    double end() const { return begin + dt; }
    double force_dt() const { return 0.5 * (dt + next_dt); }  // s, for which the forces act
};

}  // namespace tidewater::mpm
