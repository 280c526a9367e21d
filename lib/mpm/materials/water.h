// Nearly incompressible water, eq. 7 of Wolper et al. (2021).
//
//     p(J) = κw (J^(−θ) − 1)            pressure, Pa; J = volume / volume at rest
//     τ    = −J p I                     Kirchhoff stress
//     c(J) = c0 J^(−(θ−1)/2)            sound speed, m/s;  c0 = √(κw θ / ρw)
//     W(J) = κw ((J^(1−θ) − 1)/(θ − 1) + J − 1)     stored energy per volume at rest, J/m³;  p = −dW/dJ
//
// A particle keeps j = J − 1, and all formulas avoid cancellation near J = 1, so that `float` keeps the
// digits of a strain of 1e-6. Source: lib/mpm/README.md, Water. Test:
// tests/unit/mpm/materials/water_test.cpp.
#pragma once

#include <cmath>

#include "mpm/base/batch.h"

namespace tidewater::mpm {

// How a particle's volume evolves.
//     density  J follows the divergence of the flow and is slowly drawn to the space that the particle has
//              on the grid (mpm/step/crowding.h)
//     paper    J follows the divergence alone; its sum departs from that space, which causes pressure noise
enum class WaterScheme { density, paper };

// The pressure of stretched water, J > 1.
//     separate  p = 0: water opens, and has pressure again when it has closed to J = 1
//     paper     p(J) < 0: water pulls
enum class WaterTension { separate, paper };

struct WaterModel {
    double density = 1000.0;                  // ρw, kg/m³ at rest
    double sound_speed = 264.57513110645906;  // c0, m/s; the defaults have the paper's κw = 10 MPa
    int exponent = 7;                         // θ, at least 2
    WaterScheme scheme = WaterScheme::density;
    WaterTension tension = WaterTension::separate;

    double bulk_modulus() const { return density * sound_speed * sound_speed / exponent; }  // κw, Pa
};

// p(J), Pa, for J > 0.
template <class Real>
Real water_pressure(Real j, Real bulk_modulus, int exponent) {
    const Real x = Real(1) / (Real(1) + j);
    Real sum = 0;
    for (int k = 0; k < exponent; ++k) sum = x * (Real(1) + sum);
    return -bulk_modulus * j * sum;
}

// The same for a whole batch.
template <class Real>
void water_pressure(const Column<Real>& j, Real bulk_modulus, int exponent, Column<Real>& pressure) {
    Column<Real> x;
    for (int p = 0; p < batch_size; ++p) x[p] = Real(1) / (Real(1) + j[p]);
    for (int p = 0; p < batch_size; ++p) pressure[p] = x[p];
    for (int k = 1; k < exponent; ++k) {
        for (int p = 0; p < batch_size; ++p) pressure[p] = x[p] * (Real(1) + pressure[p]);
    }
    for (int p = 0; p < batch_size; ++p) pressure[p] *= -bulk_modulus * j[p];
}

// p(J), Pa, with the tension of the model, for a whole batch and for one particle.
template <class Real>
void water_pressure(const Column<Real>& j, const WaterModel& water, Column<Real>& pressure) {
    water_pressure(j, static_cast<Real>(water.bulk_modulus()), water.exponent, pressure);
    if (water.tension == WaterTension::paper) return;
    for (int p = 0; p < batch_size; ++p) pressure[p] = pressure[p] > Real(0) ? pressure[p] : Real(0);
}
template <class Real>
Real water_pressure(Real j, const WaterModel& water) {
    if (j > Real(0) && water.tension == WaterTension::separate) return Real(0);
    return water_pressure(j, static_cast<Real>(water.bulk_modulus()), water.exponent);
}

// c(J) / c0.
inline double water_sound_speed_ratio(double j, int exponent) {
    return std::exp(-0.5 * (exponent - 1.0) * std::log1p(j));
}

// W(J), J/m³, for a whole batch. Without cancellation, with u = 1/J and n = θ − 1,
//
//     W = κw j² u/n · Σ_{m=0}^{n−1} (n − m) u^m
inline void water_energy(const Column<double>& j, double bulk_modulus, int exponent, Column<double>& energy) {
    const int n = exponent - 1;
    Column<double> u;
    for (int p = 0; p < batch_size; ++p) u[p] = 1.0 / (1.0 + j[p]);
    for (int p = 0; p < batch_size; ++p) energy[p] = 1.0;
    for (int m = n - 2; m >= 0; --m) {
        for (int p = 0; p < batch_size; ++p) energy[p] = u[p] * energy[p] + (n - m);
    }
    for (int p = 0; p < batch_size; ++p) energy[p] *= bulk_modulus / n * u[p] * j[p] * j[p];
}

// The same, with the tension of the model.
inline void water_energy(const Column<double>& j, const WaterModel& water, Column<double>& energy) {
    water_energy(j, water.bulk_modulus(), water.exponent, energy);
    if (water.tension == WaterTension::paper) return;
    for (int p = 0; p < batch_size; ++p) energy[p] = j[p] > 0.0 ? 0.0 : energy[p];
}

// Water at rest under its own weight. The mass above depth h (m) is that of M metres of uncompressed water,
//
//     M(h) = (κw / ρw g) [ (1 + (1 − 1/θ) ρw g h / κw)^(θ/(θ−1)) − 1 ],
//
// which follows from dp/dh = ρw g / J(p) with p = ρw g M and J = (1 + p/κw)^(−1/θ). M(h)/h − 1 is half of the
// compression at depth h: 0.5 % at c0 = 10 √(g h).
double weighed_depth(double h, double gravity, const WaterModel& water);       // M(h), m; h where h ≤ 0
double depth_of_weight(double mass, double gravity, const WaterModel& water);  // h(M), its inverse, m
double j_under_weight(double mass, double gravity, const WaterModel& water);  // J − 1 below M; 0 where M ≤ 0

// j = J − 1 of water at rest with the scheme `paper`, at depth h (m) below its surface and with gravity in
// m/s²; 0 above the surface (h ≤ 0).
//
// Particles are seeded with equal mass at equal distances, so the grid has the density ρw and feels J p. The
// state in balance therefore solves J p(J) = ρw g h. The pressure itself is then ρw g h / J, which is too
// high by less than (c_wave/c0)²: 1 % at c0 = 31 m/s and 1 m of depth, 0.014 % at the paper's c0.
double hydrostatic_j(double h, double gravity, const WaterModel& water);

}  // namespace tidewater::mpm
