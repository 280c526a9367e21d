// A damped oscillation fitted to a record:
//
//     y(t) = (A cos ωt + B sin ωt) exp(−γt) + C
//
// by least squares: the best of a raster of ω within a fifth of a guess and of some γ, each with the best A,
// B, C, refined by Gauss & Newton's method in all five. Test: tests/unit/analysis/oscillation_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

struct Oscillation {
    double frequency = none;  // ω, rad/s
    double decay = none;      // γ, 1/s
    double cosine = none;     // A, in the record's unit
    double sine = none;       // B
    double offset = none;     // C
    double misfit = none;     // root mean square of what is left, likewise

    double at(double time) const;
    double envelope(double time) const;  // √(A² + B²) exp(−γt)
};

// time in s, at least eight samples over at least half a period of the guess (rad/s > 0); values that are not
// finite are left out. NaN if there are fewer.
Oscillation fit_oscillation(std::span<const double> time, std::span<const double> value, double guess);

}  // namespace tidewater::analysis
