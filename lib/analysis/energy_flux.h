// The energy that waves carry past a gauge, per m of crest, from its record alone. Both ways take all that is
// seen for waves that run one way, with as much kinetic as potential energy.
//
// From the spectrum, each frequency with its own group celerity (dispersion.h), of small waves of any length:
//     P = ρ g ∫ E(f) c_g(f) df                                 W/m, mean over the record
// One sinusoid of amplitude a gives ½ ρ g a² c_g.
//
// Of long waves, as the leading ones of tsunamis are, at their own speed:
//     W = ∫ ρ g η² √(g (D + η)) dt                             J/m, over the record
// A solitary wave of height a gives ρ g 8/(3√3) (aD)^(3/2), the energy of Boussinesq's, less at most a share
// of 0.1 a/D. Short waves count by up to √(gD)/c_g too much.
//
// ρ: density, g: gravity, D: still depth at the gauge, η: elevation. A run starts at rest, so that W over the
// time before the reflection comes back is the energy that passed.
//
// Test: tests/unit/analysis/energy_flux_test.cpp
#pragma once

#include <span>

#include "analysis/spectrum.h"

namespace tidewater::analysis {

struct WaterColumn {
    double depth = 0.0;       // D > 0, m
    double density = 1000.0;  // ρ > 0, kg/m³
    double gravity = 9.81;    // g > 0, m/s²
};

// P, W/m; NaN of an empty spectrum.
double spectral_energy_flux(const Spectrum& spectrum, const WaterColumn& water);

// W, J/m, by trapezia; elevation (η, m) counts from the still level. Gaps (NaN) carry nothing; NaN without
// two neighbouring samples. Where η < -D there is no water and no flux.
double long_wave_energy(std::span<const double> time, std::span<const double> elevation,
                        const WaterColumn& water);

}  // namespace tidewater::analysis
