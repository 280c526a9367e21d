// When something is written: at n · interval for n = 0, 1, 2 …
#pragma once

#include <cmath>

namespace tidewater {

// Times to the nanosecond, so that the ends of 30 intervals of 0.01 s and of 6 of 0.05 s are the same number.
inline double rounded(double time) { return std::round(time * 1e9) / 1e9; }

class Schedule {
public:
    // `past` times have come up already.
    explicit Schedule(double interval, long past = 0) : interval_(interval), past_(past) {}

    double next() const { return rounded(static_cast<double>(past_) * interval_); }
    // The first one after `time`, whether or not those before have come up.
    double after(double time) const {
        double n = std::floor(time / interval_);
        while (rounded(n * interval_) <= time) ++n;
        return rounded(n * interval_);
    }
    long past() const { return past_; }
    bool due(double time) {
        if (time < next()) return false;
        ++past_;
        return true;
    }

private:
    double interval_;
    long past_;
};

}  // namespace tidewater
