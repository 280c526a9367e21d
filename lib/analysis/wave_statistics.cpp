#include "analysis/wave_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tidewater::analysis {
namespace {

// The crest between two times, of a record without gaps.
double highest_between(std::span<const double> time, std::span<const double> value, double from, double to) {
    const auto first = std::ranges::lower_bound(time, from) - time.begin();
    const auto end = std::ranges::upper_bound(time, to) - time.begin();
    const auto peak = std::max_element(value.begin() + first, value.begin() + end);
    return fit_crest(time, value, static_cast<std::size_t>(peak - value.begin()), 0.0).value;
}

// Adds the waves of a stretch without gaps.
void add_waves(std::span<const double> time, std::span<const double> value, double margin,
               std::vector<ZeroCrossingWave>& waves) {
    std::vector<double> upside_down;
    for (const double v : value) upside_down.push_back(-v);
    std::vector<double> crossings = zero_up_crossings(time, value, margin);
    // A stretch that begins above zero begins within a wave, whose crossing is not known.
    if (!crossings.empty() && crossings.front() <= time.front()) crossings.erase(crossings.begin());
    for (std::size_t i = 1; i < crossings.size(); ++i) {
        const double from = crossings[i - 1], to = crossings[i];
        waves.push_back({from, to - from, highest_between(time, value, from, to),
                         -highest_between(time, upside_down, from, to)});
    }
}

template <class Value>
double mean(std::span<const ZeroCrossingWave> waves, const Value& value) {
    double sum = 0.0;
    for (const ZeroCrossingWave& wave : waves) sum += value(wave);
    return sum / static_cast<double>(waves.size());
}

}  // namespace

double mean_over_time(std::span<const double> time, std::span<const double> value) {
    assert(time.size() == value.size());
    double area = 0.0, length = 0.0, alone = none;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (std::isnan(value[i])) continue;
        if (std::isnan(alone)) alone = value[i];
        if (i == 0 || std::isnan(value[i - 1])) continue;
        area += 0.5 * (value[i] + value[i - 1]) * (time[i] - time[i - 1]);
        length += time[i] - time[i - 1];
    }
    return length > 0.0 ? area / length : alone;
}

std::vector<ZeroCrossingWave> zero_crossing_waves(std::span<const double> time,
                                                  std::span<const double> elevation, double zero,
                                                  double margin) {
    assert(time.size() == elevation.size() && margin >= 0.0);
    std::vector<double> value;
    for (const double eta : elevation) value.push_back(eta - zero);
    std::vector<ZeroCrossingWave> waves;
    for (std::size_t first = 0, end = 0; first < value.size(); first = end) {
        while (first < value.size() && std::isnan(value[first])) ++first;
        for (end = first; end < value.size() && !std::isnan(value[end]);) ++end;
        if (end > first)
            add_waves(time.subspan(first, end - first), std::span(value).subspan(first, end - first), margin,
                      waves);
    }
    return waves;
}

WaveStatistics wave_statistics(std::span<const ZeroCrossingWave> waves) {
    WaveStatistics s;
    s.waves = static_cast<int>(waves.size());
    if (s.waves < fewest_waves_to_trust)
        s.doubt = "fewer than " + std::to_string(fewest_waves_to_trust) + " waves";
    if (waves.empty()) {
        s.doubt = "no whole wave between zero-up-crossings";
        return s;
    }
    const auto height = [](const ZeroCrossingWave& wave) { return wave.height(); };
    const auto period = [](const ZeroCrossingWave& wave) { return wave.period; };
    std::vector<ZeroCrossingWave> highest(waves.begin(), waves.end());
    std::ranges::stable_sort(highest, std::ranges::greater(), height);
    s.greatest_height = highest.front().height();
    s.mean_height = mean(waves, height);
    s.mean_period = mean(waves, period);
    if (s.waves < fewest_waves) {
        s.doubt = "fewer than " + std::to_string(fewest_waves) + " waves";
        return s;
    }
    highest.resize((highest.size() + 2) / 3);
    s.significant_height = mean(highest, height);
    s.significant_period = mean(highest, period);
    return s;
}

}  // namespace tidewater::analysis
