#include "analysis/series.h"

#include <Eigen/Dense>
#include <cassert>
#include <cmath>

namespace tidewater::analysis {
namespace {

// When the line through two neighbouring samples, i - 1 and i, is at `level`.
double time_at(std::span<const double> time, std::span<const double> value, std::size_t i, double level) {
    const double share = (level - value[i - 1]) / (value[i] - value[i - 1]);
    return time[i - 1] + share * (time[i] - time[i - 1]);
}

}  // namespace

std::vector<double> smooth(std::span<const double> time, std::span<const double> value, double deviation) {
    assert(time.size() == value.size() && deviation >= 0.0);
    std::vector<double> smoothed(value.begin(), value.end());
    if (deviation == 0.0) return smoothed;
    std::size_t first = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        while (time[first] < time[i] - 4.0 * deviation) ++first;
        if (std::isnan(value[i])) continue;
        double sum = 0.0, weights = 0.0;
        for (std::size_t j = first; j < value.size() && time[j] <= time[i] + 4.0 * deviation; ++j) {
            if (std::isnan(value[j])) continue;
            const double distance = (time[j] - time[i]) / deviation;
            const double weight = std::exp(-0.5 * distance * distance);
            sum += weight * value[j];
            weights += weight;
        }
        smoothed[i] = sum / weights;
    }
    return smoothed;
}

Extremum fit_crest(std::span<const double> time, std::span<const double> value, std::size_t peak,
                   double drop) {
    assert(peak < value.size());
    const Extremum sample{time[peak], value[peak]};
    std::size_t first = peak, last = peak;
    const auto belongs = [&](std::size_t i) { return value[i] >= value[peak] - drop; };
    while (first > 0 && (first == peak || belongs(first - 1))) --first;
    while (last + 1 < value.size() && (last == peak || belongs(last + 1))) ++last;
    if (first == peak || last == peak) return sample;

    // Least squares for a + b u + c u², u = (t - t_peak) / scale, whose vertex is at u = -b / 2c.
    const double scale = 0.5 * (time[last] - time[first]);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = first; i <= last; ++i) {
        const double u = (time[i] - time[peak]) / scale;
        const Eigen::Vector3d powers(1.0, u, u * u);
        normal += powers * powers.transpose();
        right += value[i] * powers;
    }
    const Eigen::Vector3d fit = normal.ldlt().solve(right);
    const double at = time[peak] - 0.5 * scale * fit[1] / fit[2];
    if (!(fit[2] < 0.0) || at < time[first] || at > time[last]) return sample;
    return {at, fit[0] - 0.25 * fit[1] * fit[1] / fit[2]};
}

std::size_t find_crest(std::span<const double> value, std::size_t begin, double drop) {
    std::size_t greatest = value.size();
    for (std::size_t i = begin; i < value.size(); ++i) {
        if (std::isnan(value[i])) continue;
        if (greatest == value.size() || value[i] > value[greatest]) greatest = i;
        if (value[i] < value[greatest] - drop) return greatest;
    }
    return value.size();
}

double first_passage(std::span<const double> time, std::span<const double> value, double level) {
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (!(std::abs(value[i]) > level)) continue;
        if (i == 0 || !(std::abs(value[i - 1]) <= level)) return time[i];
        return time_at(time, value, i, std::copysign(level, value[i]));
    }
    return none;
}

std::vector<double> zero_up_crossings(std::span<const double> time, std::span<const double> value,
                                      double margin) {
    std::vector<double> crossings;
    bool armed = true, at_rest = true;
    double candidate = none;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const bool follows = i > 0 && !std::isnan(value[i - 1]);
        if (value[i] < -margin) {
            armed = true;
            at_rest = false;
        }
        if (!armed) continue;
        const double level = at_rest ? margin : 0.0;
        if (value[i] > level && !(follows && value[i - 1] > level)) {
            candidate = follows ? time_at(time, value, i, level) : time[i];
        }
        if (value[i] > margin) {
            crossings.push_back(candidate);
            armed = at_rest = false;
        }
    }
    return crossings;
}

}  // namespace tidewater::analysis
