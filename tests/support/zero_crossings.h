// The period of a sampled oscillation.
#pragma once

#include <vector>

namespace tidewater::test {

// Collects the times at which a signal changes its sign, by linear interpolation between samples.
class ZeroCrossings {
public:
    void add(double time, double value) {
        if (samples_++ > 0 && (value > 0.0) != (value_ > 0.0))
            times_.push_back(time_ + (time - time_) * value_ / (value_ - value));
        time_ = time;
        value_ = value;
    }
    std::size_t count() const { return times_.size(); }
    double period() const {
        return 2.0 * (times_.back() - times_.front()) / static_cast<double>(times_.size() - 1);
    }

private:
    std::vector<double> times_;
    long samples_ = 0;
    double time_ = 0.0, value_ = 0.0;
};

}  // namespace tidewater::test
