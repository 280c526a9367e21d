// When something is due: at n · interval for n = 0, 1, 2 … A step never ends early for it: a row is then made
// between the steps around its time, a frame is the first whole step at or after it.
#pragma once

#include <algorithm>
#include <cmath>

namespace tidewater {

// Times to the nanosecond, so that the ends of 30 intervals of 0.01 s and of 6 of 0.05 s are the same number.
inline double rounded(double time) { return std::round(time * 1e9) / 1e9; }

class Schedule {
public:
    // `past` times have come up before.
    explicit Schedule(double interval, long past = 0) : interval_(interval), past_(past) {}

    double next() const { return rounded(static_cast<double>(past_) * interval_); }
    long past() const { return past_; }
    void pass() { ++past_; }
    // Whether one or more have come up by `time`; they are past then.
    bool due(double time) {
        if (time < next()) return false;
        // Nearly there at once: a step may pass any number of times.
        past_ = std::max(past_ + 1, static_cast<long>(time / interval_) - 1);
        while (next() <= time) ++past_;
        return true;
    }

private:
    double interval_;
    long past_;
};

}  // namespace tidewater
