// The celerity of long waves that gauges imply, of waves too low, too gradual or too dispersed for a crest to
// be followed: how fast must long waves be so that linear dispersion makes of each gauge's record the next
// one's?
//
//     η̂(x + d, ω) = η̂(x, ω) e^(−i k d),   ω² = (c²/D) k tanh(kD),   ω ≤ 8 √(c²/D)/√D
//
// c, the one unknown, is √(gD) in theory. It is where the sum over neighbouring gauges and times of the
// squared misfit is least, of 0.6 to 1.6 √(gD) in steps of 0.01, refined by a parabola. Its error is the
// jackknife's, √((n−1)/n Σ (c_(j) − c̄)²), c_(j) without pair j; it holds scatter among pairs, no bias that
// they share, such as a finite amplitude's (c rises by about ½ a/D for a crest a, and falls for a trough).
//
// Records begin with the disturbance, at rest, and may end while the wave passes: linear waves go no faster
// than c, so the part of a record after its end says nothing of the next one before that. Each is smoothed as
// in wave.h and counts from its first sample. They must end before reflections arrive; waves in one
// direction only.
//
// Source: transfer of surface elevation between gauges by linear theory, e.g. R. G. Dean & R. A. Dalrymple
// (1991), Water Wave Mechanics, ch. 3; the fit of c is our own. Test:
// tests/unit/analysis/celerity_fit_test.cpp, against Fourier's integral with noise.
#pragma once

#include <span>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

struct CelerityFit {
    double celerity = none;  // c, m/s; NaN with fewer than two pairs, without a least misfit in the range, or
                             // when less than half of the records' squares is explained
    double error = none;     // standard, m/s
    double explained = none;  // 1 − misfit² / Σ η², at the least misfit; ≤ 1
    int pairs = 0;
};

// distance: of the gauges from the source, m, rising, one direction. time: evenly spaced, s, at least 4.
// records: η, m, one per gauge and as long as time; pairs with a NaN in one of theirs are left out.
CelerityFit fit_celerity(std::span<const double> distance, std::span<const double> time,
                         std::span<const std::vector<double>> records, double depth, double gravity);

}  // namespace tidewater::analysis
