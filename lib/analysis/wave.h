// What a gauge saw: when the wave arrived, how high and how long it was; and how fast it went from gauge to
// gauge.
//
// Surface elevations η read from particles carry noise of some hundredths of a cell, which changes as
// particles pass below the gauge. So all times and heights are taken from η smoothed over time with a
// Gaussian of standard deviation 0.1 √(D/g): a wave as long as the water is deep loses 3 % of its amplitude,
// a solitary wave of 0.3 D 0.3 %, and longer ones less. What is left is told from waves by
// `smallest_amplitude`.
//
// The still surface as read may be off by a part of a cell, where the depth is not on the particles' lattice.
// So arrival, thresholds and zero crossings are taken from η - η0, where η0 is the first sample that is not
// NaN, after the smoothing, and "greatest |η|" below is that of η - η0. Crests and troughs are given as η
// itself.
//
// Reflections: a gauge's record ends, for everything below, when a wave of speed √(gD) that passed it at the
// arrival would be back from the far wall. A gauge closer to that wall than the leading crest is to its own
// front has no crest.
#pragma once

#include <span>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

struct WaveSettings {
    double depth = 0.0;               // D of the still water > 0, m
    double gravity = 9.81;            // g > 0, m/s²
    double far_wall = 0.0;            // x of the wall that the waves run towards, m
    double arrival_threshold = 0.05;  // share of the record's greatest |η|, in (0, 1)
    double smallest_amplitude = 0.0;  // m, of η - η0; a record that nowhere exceeds it holds no wave
};

// NaN stands for what the record does not hold: no wave, no crest yet, no second wave.
struct GaugeWave {
    double x = none;           // of the gauge, m
    double arrival = none;     // s; |η - η0| first passes the threshold
    double crest_time = none;  // s, of the leading crest
    double crest = none;       // η of the leading crest, m
    double trough =
        none;  // lowest η of the leading wave after its crest, m; none if the record ends in the fall
    double height = none;         // crest - trough, m
    double period = none;         // s, of the leading wave, between zero-up-crossings
    double greatest = none;       // greatest η of the whole record, reflections too, m
    double greatest_time = none;  // s
    double lowest = none;         // lowest η, likewise, m
    double mean_period = none;    // s, between the record's first and last zero-up-crossing
    double record_end = none;     // s; when the reflection comes back or the record ends
};

// time and elevation (η, m; NaN where dry) have the same length, which may be 0. A crest falls by at least
// 0.1 of the record's greatest |η|, else it is a ripple; its time and height come from a parabola through
// what lies within 0.2 of it. Zero-up-crossings use the arrival's threshold as margin. See series.h.
GaugeWave analyse_gauge(double x, std::span<const double> time, std::span<const double> elevation,
                        const WaveSettings& settings);

// The record smoothed as above, less η0.
struct RecordChange {
    double rest = 0.0;          // η0, m; 0 if all is NaN
    std::vector<double> value;  // m; NaN where dry
};
RecordChange change_from_rest(std::span<const double> time, std::span<const double> elevation, double depth,
                              double gravity);

// √(gD), m/s: the speed of long waves of small amplitude.
double long_wave_celerity(double depth, double gravity);

// Speeds in m/s, from the times of leading crests and from those of arrivals; NaN where a time is missing or
// the times do not increase with x.
struct Celerity {
    double from_crests = none;
    double from_arrivals = none;
};

// From each gauge to the next; gauges are in the order of x. One fewer than there are gauges.
std::vector<Celerity> celerity_between(std::span<const GaugeWave> gauges);

// 1 / slope of the line of least squares t = t0 + x / c through all gauges that have a time; at least two are
// needed.
Celerity celerity_overall(std::span<const GaugeWave> gauges);

}  // namespace tidewater::analysis
