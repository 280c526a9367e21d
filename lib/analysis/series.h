// Records over time: smoothing, extrema between samples, zero crossings. Times are strictly increasing, in s,
// and need not be evenly spaced; a value may be NaN where there is none (a dry gauge). time and value have
// the same length.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace tidewater::analysis {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Mean over neighbouring samples weighted by a Gaussian of standard deviation `deviation` (s; 0: no
// smoothing), cut off at four deviations. A component of angular frequency ω keeps exp(-(ω deviation)² / 2)
// of its amplitude. NaN are left out of the mean, and stay NaN.
std::vector<double> smooth(std::span<const double> time, std::span<const double> value, double deviation);

struct Extremum {
    double time = none;  // s
    double value = none;
};

// The vertex of the parabola of least squares through the samples around sample `peak`, a local maximum, that
// lie within `drop` of it, and at least through its two neighbours. The sample itself where no parabola with
// a vertex among those samples exists, as at the record's ends.
Extremum fit_crest(std::span<const double> time, std::span<const double> value, std::size_t peak,
                   double drop);

// The first sample, from `begin` on, that is followed by a fall of more than `drop` before anything greater:
// the first crest that is no ripple. value.size() if there is none.
std::size_t find_crest(std::span<const double> value, std::size_t begin, double drop);

// When |value| first passes `level`, linearly between samples; NaN if it does not.
double first_passage(std::span<const double> time, std::span<const double> value, double level);

// The zero-up-crossings: when the value rises through 0 after having been below -margin and before passing
// margin, so that ripples around 0 do not count. A first rise out of rest, without a fall below -margin
// before it, counts from where it passes margin.
std::vector<double> zero_up_crossings(std::span<const double> time, std::span<const double> value,
                                      double margin);

}  // namespace tidewater::analysis
