// From a wave in a flume (2D) to one that spreads from a block into open water (3D), by formulas fitted to
// laboratory experiments.
//
// Heller & Spinneken (2015), eqs. 11 to 13 of Wolper et al. (2021):
//     a3D/a2D = 1.5 (r/D)^(−5/6) F^0.40 S^0.50 M^0.50 fγ,     fγ = cos^{2(1 + exp(−0.2 r/D))}(2γ/3)
//     F = v/√(gD)          slide Froude number, v: the slide's greatest speed
//     S = s/D              relative thickness
//     M = m/(ρw b D²)      relative mass, b: the slide's width
// r: distance from the impact, γ: angle from the slide's direction. (The exponent −5/6 is +5/6 in the text of
// the paper as extracted; only the negative one gives a wave that decays.) The stated scatter is ±50 %.
//
// Impulse product (Heller & Hager 2010; VAW manual 2019), of slides that come down a slope of angle α:
//     P = F S^½ M^¼ √cos(6α/7)
//     aM = (4/9) P^0.8 D          greatest amplitude near the impact
//     H(x) = ¾ (P (x/D)^(−1/3))^0.8 D          wave height in the flume, crest to trough
// fitted within F 0.86–6.83, S 0.09–1.64, M 0.11–10.02, P 0.17–8.13. A block that falls or rises upright is
// α = 90°, which gives the smallest P.
//
// Figures: lib/analysis/README.md, Slides. Test: tests/unit/analysis/radial_wave_test.cpp.
#pragma once

#include <array>

namespace tidewater::analysis {

struct Slide {
    double speed = 0.0;             // v ≥ 0, m/s
    double thickness = 0.0;         // s > 0, m
    double mass = 0.0;              // m > 0, kg; in 2D per m of width, with width = 1
    double width = 1.0;             // b > 0, m
    double depth = 0.0;             // D of the water > 0, m
    double water_density = 1000.0;  // ρw, kg/m³
    double gravity = 9.81;          // g, m/s²

    double froude() const;           // F
    double thickness_ratio() const;  // S
    double mass_ratio() const;       // M
};

// r/D at which Heller et al. (2019) had gauges, icebergs that capsize up to 15.
inline constexpr std::array laboratory_distances{2.0, 5.0, 10.0, 15.0, 35.0};

inline constexpr double radial_scatter = 0.5;  // of radial_factor, either way

// a3D/a2D at r/D > 0; angle: γ in degrees, −90 to 90.
double radial_factor(const Slide& slide, double distance_ratio, double angle = 0.0);

struct ImpulseProduct {
    double value = 0.0;      // P
    double amplitude = 0.0;  // aM, m
    double depth = 0.0;      // D, m
    // Whether each lies within what the formulas were fitted to.
    bool froude_is_valid = false, thickness_is_valid = false, mass_is_valid = false, value_is_valid = false;

    bool is_valid() const { return froude_is_valid && thickness_is_valid && mass_is_valid && value_is_valid; }

    // H at x/D > 0 from the impact, m.
    double height(double distance_ratio) const;
};

// slope: α in degrees, 0 to 90.
ImpulseProduct impulse_product(const Slide& slide, double slope = 90.0);

}  // namespace tidewater::analysis
