// How waves fall with distance, and how high they run up a shore.
//
// Decay: a = A (r/D)^-n through amplitudes a at distances r, by least squares in logarithms,
//     ln a = ln A − n ln(r/D),
// with n's 95 % interval n ± t s_n: s_n is its standard error and t Student's quantile of N − 2 degrees of
// freedom (NaN of two gauges). Cylindrical spreading without loss gives n = 1/2, the 2D→3D transform's tail
// 5/6 (radial_wave.h), a solitary wave in a flume 0.
//
// Run-up: the highest wet place over time is a record as any other; its greatest value counts.
//
// Test: tests/unit/analysis/decay_test.cpp
#pragma once

#include <span>
#include <string>

#include "analysis/series.h"

namespace tidewater::analysis {

struct AmplitudeDecay {
    double amplitude = none;                           // A, m, that of the fit at r = D
    double exponent = none;                            // n
    double exponent_low = none, exponent_high = none;  // of its 95 % interval
    double misfit = none;                              // rms of ln a about the line
    int gauges = 0;                                    // that count
    std::string doubt;                                 // why not to trust the fit; empty: it can be trusted

    bool trustworthy() const { return doubt.empty(); }
};

// distance: r, m; amplitude: a, m, of equal length, in any order; depth: D > 0, m. Gauges whose r or a is not
// a finite number > 0 do not count; with fewer than two at different distances all is NaN. Doubtful: fewer
// than 4 gauges, or n ≤ 0.
AmplitudeDecay fit_decay(std::span<const double> distance, std::span<const double> amplitude, double depth);

// t with P(|T| < t) = 0.95 of Student's distribution with `freedom` ≥ 1 degrees of freedom (Abramowitz &
// Stegun 26.7.3 and 26.7.4, inverted by bisection); NaN below 1.
double student_quantile(int freedom);

// The greatest value and its first time; NaN if no value is a number.
Extremum greatest_run_up(std::span<const double> time, std::span<const double> height);

}  // namespace tidewater::analysis
