#include "analysis/wave.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tidewater::analysis {
namespace {

constexpr double smoothing = 0.1;  // deviation, in √(D/g)
// In the record's greatest |η|, which is `scale` below.
constexpr double crest_drop = 0.1;  // a smaller fall is a ripple
constexpr double crest_fit = 0.2;   // the parabola goes through what lies within this of the crest

// Greatest |η| among the first `count` samples; 0 if all are NaN.
double greatest_excursion(std::span<const double> value, std::size_t count) {
    double greatest = 0.0;
    for (const double v : value.first(count)) {
        if (std::abs(v) > greatest) greatest = std::abs(v);
    }
    return greatest;
}

std::size_t count_until(std::span<const double> time, double end) {
    return static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), end) - time.begin());
}

void find_extremes(std::span<const double> time, std::span<const double> value, double scale,
                   GaugeWave& wave) {
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (!(value[i] <= value[greatest])) greatest = std::isnan(value[i]) ? greatest : i;
        if (!(value[i] >= wave.lowest) && !std::isnan(value[i])) wave.lowest = value[i];
    }
    const Extremum crest = fit_crest(time, value, greatest, crest_fit * scale);
    wave.greatest = crest.value;
    wave.greatest_time = crest.time;
}

// The leading wave's crest is the first that rises above `margin`; a trough may lead it.
void find_leading_wave(std::span<const double> time, std::span<const double> value, double margin,
                       double scale, std::span<const double> crossings, GaugeWave& wave) {
    const auto risen = std::find_if(value.begin(), value.end(), [&](double v) { return v > margin; });
    const std::size_t peak =
        find_crest(value, static_cast<std::size_t>(risen - value.begin()), crest_drop * scale);
    if (peak == value.size()) return;
    const Extremum crest = fit_crest(time, value, peak, crest_fit * scale);
    wave.crest = crest.value;
    wave.crest_time = crest.time;

    const auto next = std::upper_bound(crossings.begin(), crossings.end(), crest.time);
    const std::size_t end = next == crossings.end() ? value.size() : count_until(time, *next);
    std::size_t lowest = peak;
    for (std::size_t i = peak; i < end; ++i) {
        if (value[i] < value[lowest]) lowest = i;
    }
    // The record ends in the fall if its last quarter since the crest still fell by as much as counts as a
    // wave.
    const std::size_t before = count_until(time, 0.75 * time.back() + 0.25 * time[peak]) - 1;
    const bool still_falls = lowest + 1 == value.size() && value[before] - value[lowest] > margin;
    if (!still_falls) {
        wave.trough = value[lowest];
        wave.height = wave.crest - wave.trough;
    }
    if (next != crossings.end() && next != crossings.begin()) wave.period = *next - *(next - 1);
}

double speed(double distance, double duration) { return duration > 0.0 ? distance / duration : none; }

// The time is a member of GaugeWave: crest_time or arrival.
double fitted_celerity(std::span<const GaugeWave> gauges, double GaugeWave::*time) {
    double count = 0.0, mean_x = 0.0, mean_t = 0.0;
    for (const GaugeWave& gauge : gauges) {
        if (std::isnan(gauge.*time)) continue;
        count += 1.0;
        mean_x += (gauge.x - mean_x) / count;
        mean_t += (gauge.*time - mean_t) / count;
    }
    double xx = 0.0, xt = 0.0;
    for (const GaugeWave& gauge : gauges) {
        if (std::isnan(gauge.*time)) continue;
        xx += (gauge.x - mean_x) * (gauge.x - mean_x);
        xt += (gauge.x - mean_x) * (gauge.*time - mean_t);
    }
    return speed(xx, xt);
}

// `all` is smoothed and starts from 0.
GaugeWave analyse_change(double x, std::span<const double> time, std::span<const double> all,
                         const WaveSettings& settings) {
    GaugeWave wave;
    wave.x = x;
    if (time.empty()) return wave;
    const double celerity = long_wave_celerity(settings.depth, settings.gravity);

    // The reflection's time follows from the arrival and shortens the record, whose greatest |η| decides the
    // arrival.
    std::size_t count = all.size();
    wave.record_end = time.back();
    for (int pass = 0; pass < 2; ++pass) {
        const double greatest = greatest_excursion(all, count);
        if (greatest > settings.smallest_amplitude) {
            wave.arrival = first_passage(time, all, settings.arrival_threshold * greatest);
            wave.record_end =
                std::min(time.back(), wave.arrival + 2.0 * std::abs(settings.far_wall - x) / celerity);
        }
        count = count_until(time, wave.record_end);
    }

    const auto value = all.first(count);
    const auto until = time.first(count);
    const double greatest = greatest_excursion(value, count);
    find_extremes(time, all, greatest_excursion(all, all.size()), wave);  // with what came back from the wall
    if (std::isnan(wave.arrival)) return wave;
    const double margin = settings.arrival_threshold * greatest;
    const auto crossings = zero_up_crossings(until, value, margin);
    find_leading_wave(until, value, margin, greatest, crossings, wave);
    if (crossings.size() > 1) {
        wave.mean_period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    }
    return wave;
}

}  // namespace

GaugeWave analyse_gauge(double x, std::span<const double> time, std::span<const double> elevation,
                        const WaveSettings& settings) {
    assert(time.size() == elevation.size() && settings.depth > 0.0 && settings.gravity > 0.0);
    const RecordChange change = change_from_rest(time, elevation, settings.depth, settings.gravity);
    GaugeWave wave = analyse_change(x, time, change.value, settings);
    for (double* level : {&wave.crest, &wave.trough, &wave.greatest, &wave.lowest}) *level += change.rest;
    return wave;
}

RecordChange change_from_rest(std::span<const double> time, std::span<const double> elevation, double depth,
                              double gravity) {
    RecordChange change{.value = smooth(time, elevation, smoothing * std::sqrt(depth / gravity))};
    const auto first = std::ranges::find_if(change.value, [](double value) { return !std::isnan(value); });
    if (first != change.value.end()) change.rest = *first;
    for (double& value : change.value) value -= change.rest;
    return change;
}

double long_wave_celerity(double depth, double gravity) { return std::sqrt(gravity * depth); }

std::vector<Celerity> celerity_between(std::span<const GaugeWave> gauges) {
    std::vector<Celerity> speeds;
    for (std::size_t i = 1; i < gauges.size(); ++i) {
        const GaugeWave &a = gauges[i - 1], &b = gauges[i];
        speeds.push_back(
            {speed(b.x - a.x, b.crest_time - a.crest_time), speed(b.x - a.x, b.arrival - a.arrival)});
    }
    return speeds;
}

Celerity celerity_overall(std::span<const GaugeWave> gauges) {
    return {fitted_celerity(gauges, &GaugeWave::crest_time), fitted_celerity(gauges, &GaugeWave::arrival)};
}

}  // namespace tidewater::analysis
