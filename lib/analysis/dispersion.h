// Waves of small amplitude over a flat bed: length and speed of a wave of given period.
//
//     ω² = g k tanh(kD),    c = ω/k,    c_g = dω/dk = ½ c (1 + 2kD/sinh 2kD)
//
// ω: angular frequency, k: wavenumber, D: still depth, g: gravity, c: celerity, c_g: group celerity, at which
// energy goes. Long waves: c = c_g = √(gD); in deep water c_g = ½ c = g/2ω.
//
// Test: tests/unit/analysis/dispersion_test.cpp
#pragma once

namespace tidewater::analysis {

// k > 0, 1/m, of ω > 0, rad/s, to rounding; depth, gravity > 0. The inverse of angular_frequency
// (wave_theory.h).
double dispersion_wavenumber(double frequency, double depth, double gravity);

// c_g, m/s, of ω ≥ 0; √(gD) at 0.
double group_celerity(double frequency, double depth, double gravity);

}  // namespace tidewater::analysis
