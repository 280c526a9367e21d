// How many fragments there are of which size s: areas (m²) or volumes (m³), all of one kind.
//
// Models of the density of sizes s ≥ s_min, per unit of s, each with ∫ p ds = 1 from s_min on:
//     power law                p = (a − 1)/s_min (s/s_min)^−a                              a > 1
//     truncated power law      p = s^−a exp(−s/s_c) / ∫ s^−a exp(−s/s_c) ds                s_c > 0
//     exponential              p = exp(−(s − s_min)/s_c) / s_c
// all fitted by maximum likelihood (Clauset, Shalizi & Newman 2009, SIAM Review 51, 661-703). In t = s/s_min
// and x = s_min/s_c the truncated one is an exponential family in ln t and t, so Newton's method finds the
// one maximum; its integrals are taken in ln t by Simpson's rule (512 intervals).
//
// s_min, where not given, is the size from which the power law's Kolmogorov–Smirnov distance is least, of up
// to 100 candidates evenly spread in rank that leave at least 10 fragments. All models use the same s_min.
// The choice scatters upward: where 1000 sizes of a power law from 5 on lie above 300 even ones, the median
// of 100 sets is 5.2, a tenth lies above 11.4, and the exponent's interval still holds 94 of 100.
//
// Intervals hold 95 %, from the observed information: a ± 1.96 (a − 1)/√n, s_c exp(± 1.96/√n) of the
// exponential; of the truncated law from the matrix of (a, ln s_c). They take s_min as known.
//
// Goodness of fit: the KS distance, with p the share of 200 sets drawn from the fitted model that, fitted
// again, lie farther from their own fit. Where s_min was chosen, the power law's sets draw sizes below s_min
// from the data and choose their own (Clauset et al., §4.1). p < 0.1 speaks against the model. Draws are
// counter-based: the same seed gives the same p on any number of threads.
//
// Comparisons: power law against exponential by Vuong's test (not nested), truncated against either by the
// χ² of one degree of freedom (nested).
//
// Test: tests/unit/analysis/size_distribution_test.cpp
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

// Published exponents a of n(s) ∝ s^−a, lib/analysis/README.md, Sizes.
inline constexpr double fragment_exponent_2d = 1.5;   // fragments of brittle ice, with a cut-off
inline constexpr double fragment_exponent_3d = 1.67;  // likewise, of volumes
inline constexpr double iceberg_area_exponent_low = 1.6, iceberg_area_exponent_high = 1.95;  // Sulak 2017

struct Exceedance {
    double size = 0.0;      // s
    std::size_t count = 0;  // N(≥ s)
};

// One entry per different size, rising. Here and below only sizes that are finite and > 0 count.
std::vector<Exceedance> exceedance(std::span<const double> sizes);

struct SizeBin {
    double low = 0.0, high = 0.0;  // low ≤ s < high; the last bin holds its upper edge too
    std::size_t count = 0;
    double density = 0.0;  // n(s): count / (high − low)
};

// Bins of equal width in log s, `per_decade` ≥ 1 a decade, from the least size on; empty ones too.
std::vector<SizeBin> logarithmic_histogram(std::span<const double> sizes, int per_decade);

enum class SizeModel { power_law, truncated_power_law, exponential };

struct Interval {
    double low = none, high = none;

    bool holds(double value) const { return low <= value && value <= high; }
};

// NaN: the model has no such number, or there was no fit. A truncated law whose cut-off lies beyond 1000
// times the largest size is cut off there: it is a power law.
struct SizeFit {
    SizeModel model = SizeModel::power_law;
    double exponent = none;  // a
    Interval exponent_interval{};
    double cutoff = none;  // s_c
    Interval cutoff_interval{};
    double log_likelihood = none;
    double distance = none;  // Kolmogorov & Smirnov's, 0 to 1
    double p = none;         // of the distance
};

struct LikelihoodRatio {
    double ratio = none;  // ln L of the first model − ln L of the second: > 0 speaks for the first
    double p = none;      // of a ratio as great if both were as good
};

struct SizeSettings {
    double smallest = none;  // s_min > 0; NaN: chosen
    int replicates = 200;    // of the bootstrap; 0: no p
    std::uint64_t seed = 1;
};

struct SizeDistribution {
    double smallest = none;  // s_min
    std::size_t count = 0;   // of sizes ≥ s_min
    double decades = none;   // log10 of the largest size over s_min
    SizeFit power_law, truncated, exponential;
    LikelihoodRatio power_over_exponential, truncated_over_power, truncated_over_exponential;
    std::string doubt;  // why not to trust the fits: fewer than 50 fragments, less than one decade, all alike

    bool trustworthy() const { return doubt.empty(); }
};

// Of fewer than two different sizes ≥ s_min no fit.
SizeDistribution fit_sizes(std::span<const double> sizes, const SizeSettings& settings = {});

// The share of sizes >= smallest that are at least `size` >= smallest, by a model with the exponent and
// cut-off of `fit`; NaN without.
double modelled_exceedance(const SizeFit& fit, double smallest, double size);

// Size of rank u in [0, 1) of a model with the exponent and cut-off of `fit`, s_min = smallest: for drawing.
std::vector<double> draw_sizes(const SizeFit& fit, double smallest, std::size_t count, std::uint64_t seed,
                               std::uint64_t stream);

}  // namespace tidewater::analysis
