// The time of one step of the engine.
//
// Particles move through [begin, begin + dt] with the velocities that the nodes have; then the nodes get the
// forces of the step that follows, of length next_dt.
#pragma once

namespace tidewater::mpm {

struct Interval {
    long step = 0;          // how many came before
    double begin = 0.0;     // s
    double dt = 0.0;        // s
    double next_dt = 0.0;   // s
    bool settling = false;  // time has not begun: ice does not fail and no boundary moves

    double end() const { return begin + dt; }
};

}  // namespace tidewater::mpm
