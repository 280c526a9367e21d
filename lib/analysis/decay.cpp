#include "analysis/decay.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace tidewater::analysis {
namespace {

constexpr int fewest_gauges = 4;

// P(|T| < t)
double student_probability(double t, int freedom) {
    const double angle = std::atan(t / std::sqrt(freedom));
    const double c = std::cos(angle), s = std::sin(angle);
    const bool odd = freedom % 2 == 1;
    double term = odd ? c : 1.0, sum = freedom == 1 ? 0.0 : term;
    for (int k = odd ? 3 : 2; k <= freedom - 2; k += 2) {
        term *= c * c * (k - 1.0) / k;
        sum += term;
    }
    return odd ? 2.0 / std::numbers::pi * (angle + s * sum) : s * sum;
}

}  // namespace

double student_quantile(int freedom) {
    if (freedom < 1) return none;
    double low = 0.0, high = 13.0;  // 12.71 of one degree
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (student_probability(middle, freedom) < 0.95 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

AmplitudeDecay fit_decay(std::span<const double> distance, std::span<const double> amplitude, double depth) {
    assert(distance.size() == amplitude.size() && depth > 0.0);
    std::vector<double> x, y;
    const auto counts = [](double v) { return std::isfinite(v) && v > 0.0; };
    for (std::size_t i = 0; i < distance.size(); ++i) {
        if (!counts(distance[i]) || !counts(amplitude[i])) continue;
        x.push_back(std::log(distance[i] / depth));
        y.push_back(std::log(amplitude[i]));
    }
    AmplitudeDecay fit;
    fit.gauges = static_cast<int>(x.size());
    const double count = fit.gauges;
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / count;
        mean_y += y[i] / count;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (fit.gauges < fewest_gauges) fit.doubt = "fewer than 4 gauges";
    if (fit.gauges < 2 || !(xx > 1e-20)) {
        fit.doubt = "fewer than 2 gauges at different distances";
        return fit;
    }
    fit.exponent = -xy / xx;
    fit.amplitude = std::exp(mean_y + fit.exponent * mean_x);
    double squares = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double left = y[i] - mean_y + fit.exponent * (x[i] - mean_x);
        squares += left * left;
    }
    fit.misfit = std::sqrt(squares / count);
    const double half = student_quantile(fit.gauges - 2) * std::sqrt(squares / (count - 2.0) / xx);
    fit.exponent_low = fit.exponent - half;
    fit.exponent_high = fit.exponent + half;
    if (fit.doubt.empty() && fit.exponent <= 0.0) fit.doubt = "the amplitudes do not fall with distance";
    return fit;
}

Extremum greatest_run_up(std::span<const double> time, std::span<const double> height) {
    assert(time.size() == height.size());
    Extremum greatest;
    for (std::size_t i = 0; i < height.size(); ++i) {
        if (!std::isnan(height[i]) && !(height[i] <= greatest.value)) greatest = {time[i], height[i]};
    }
    return greatest;
}

}  // namespace tidewater::analysis
