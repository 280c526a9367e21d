// The waves of a record one by one, between zero-up-crossings, and what is said of all of them.
//
// A wave reaches from one zero-up-crossing to the next (series.h); its height H is its crest minus its
// trough, each from the parabola through its highest, or lowest, sample and the two beside it. Zero is the
// still level, or the mean of a record that does not begin at rest. Waves that a gap (NaN) cuts do not count,
// nor does what comes before the first crossing and after the last.
//
//     H_max    greatest height              H_m   mean height
//     H_1/3    mean of the highest third, rounded up to whole waves: the significant height H_s
//     T_z      mean period                  T_1/3 mean period of that third
//
// Of waves whose heights follow Rayleigh's distribution H_1/3 = 1.60 H_m = 4.00 σ, σ² the record's variance;
// the mean height of N of them scatters by 0.52/√N of itself, 10 % at N = 30.
//
// Test: tests/unit/analysis/wave_statistics_test.cpp
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

struct ZeroCrossingWave {
    double start = none;   // s, of its zero-up-crossing
    double period = none;  // s
    double crest = none;   // m, above zero
    double trough = none;  // m, likewise

    double height() const { return crest - trough; }
};

inline constexpr int fewest_waves = 3;  // for H_1/3 and T_1/3
inline constexpr int fewest_waves_to_trust = 30;

struct WaveStatistics {
    int waves = 0;
    double mean_height = none;         // H_m, m
    double significant_height = none;  // H_1/3, m; none of fewer than fewest_waves
    double greatest_height = none;     // H_max, m
    double mean_period = none;         // T_z, s
    double significant_period = none;  // T_1/3, s
    std::string doubt;                 // why not to trust them as statistics; empty: they can be trusted
};

// time and elevation (m; NaN: dry) as for all of series.h. zero: m. margin: m ≥ 0, a rise that stays within
// it of zero is no crossing.
std::vector<ZeroCrossingWave> zero_crossing_waves(std::span<const double> time,
                                                  std::span<const double> elevation, double zero,
                                                  double margin);

WaveStatistics wave_statistics(std::span<const ZeroCrossingWave> waves);

// The mean of a record over its time, by trapezia between neighbouring samples that are numbers; of its one
// sample if there is no more; NaN if there is none.
double mean_over_time(std::span<const double> time, std::span<const double> value);

}  // namespace tidewater::analysis
