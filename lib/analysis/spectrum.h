// Variance density spectra of records of the surface elevation, and what follows from their moments.
//
// One-sided: ∫ E(f) df from 0 to the Nyquist frequency is the record's variance, exactly, of the frequencies
// f_k = k Δf, k = 0 … K, as Σ E_k Δf w_k with w = ½ at both ends and 1 between.
//
// A record that is not evenly sampled is first read linearly at even times of its mean step; a component of
// period T loses at most (π Δt/T)²/2 of its amplitude by that, 1.2 % at 20 samples per period. Of a record
// with gaps (NaN) the longest stretch without one counts. The straight line of least squares is taken off;
// variance is about that line.
//
// Welch's method: the record is cut into `segments` of equal length that overlap by half. Each is multiplied
// with Tukey's window, of whose length the share `taper` falls off as a cosine, half of it at either end (1
// is Hann's window), and padded with zeros to a power of two of at least four times its length, so that a
// peak is seen between the frequencies that its length resolves. The mean of the squared amplitudes is scaled
// to the record's variance, which makes up for what the windows take.
//
//     m_n = ∫ fⁿ E df,   H_m0 = 4 √m0,   T_m01 = m0/m1,   T_m02 = √(m0/m2),
//     T_p = 1/f_p, f_p the top of the parabola through ln E at the greatest E and its two neighbours
//
// Source: P. D. Welch (1967), IEEE Trans. Audio Electroacoust. 15, 70-73; L. H. Holthuijsen (2007), Waves in
// Oceanic and Coastal Waters, ch. 3 and 4. Test: tests/unit/analysis/spectrum_test.cpp
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

struct SpectrumSettings {
    int segments = 1;    // ≥ 1
    double taper = 1.0;  // in [0, 1]
};

struct Spectrum {
    std::vector<double> frequency;  // f, Hz
    std::vector<double> density;    // E, m²/Hz
    double from = none, to = none;  // s, the stretch of the record that counts
    double resolution = none;       // Hz, 1/the length of a segment
    std::string doubt;              // why there is none or not to trust it; empty: it can be trusted

    double width(std::size_t k) const;  // Δf w_k, Hz
    double moment(int order) const;     // m_n, m² Hzⁿ; 0 of an empty spectrum
    bool peak_is_resolved() const;      // E is greatest at two resolutions or above
    // These are NaN where the peak is not resolved: the line that was taken off took a part of the waves.
    double significant_height() const;    // H_m0, m
    double peak_period() const;           // T_p, s
    double mean_period() const;           // T_m01, s
    double zero_crossing_period() const;  // T_m02, s
};

inline constexpr std::size_t fewest_samples = 16;  // of a segment

// time and elevation (m) as for all of series.h. Empty, with a doubt, of fewer samples than fewest_samples a
// segment. Doubtful: E is greatest below two resolutions: the record is too short for its waves; or gaps take
// more than a tenth of it.
Spectrum wave_spectrum(std::span<const double> time, std::span<const double> elevation,
                       const SpectrumSettings& settings = {});

}  // namespace tidewater::analysis
