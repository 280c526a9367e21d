// Nearly incompressible water, eq. 7 of Wolper et al. (2021).
//
//     p(J) = κw (J^(−θ) − 1)            pressure, Pa; J = volume / volume at rest
//     c(J) = c0 J^(−(θ−1)/2)            sound speed, m/s;  c0 = √(κw θ / ρw)
//     W(J) = κw ((J^(1−θ) − 1)/(θ − 1) + J − 1)     stored energy per volume at rest, J/m³;  p = −dW/dJ
//     J(z) = (1 + ρw g h/κw)^(−1/θ)     at depth h below the surface of water at rest
//
// The state kept per particle is j = J − 1, and everything is evaluated with expm1 and log1p, so that `float` keeps the
// digits of a strain of 1e-6. Source: shared/physics.md §3. Test: tests/unit/mpm/water_test.cpp.
#pragma once

#include <cmath>

namespace tidewater::mpm {

struct WaterModel {
    double density = 1000.0;                  // ρw, kg/m³ at rest
    double sound_speed = 264.57513110645906;  // c0, m/s; with the defaults κw = 10 MPa, the paper's
    double exponent = 7.0;                    // θ

    double bulk_modulus() const { return density * sound_speed * sound_speed / exponent; }  // κw, Pa
};

// p(J), Pa.
template <class Real>
Real water_pressure(Real j, Real bulk_modulus, Real exponent) {
    return bulk_modulus * std::expm1(-exponent * std::log1p(j));
}

// c(J) / c0.
template <class Real>
Real water_sound_speed_ratio(Real j, Real exponent) {
    return std::exp(Real(-0.5) * (exponent - Real(1)) * std::log1p(j));
}

// W(J), J/m³.
inline double water_energy(double j, double bulk_modulus, double exponent) {
    return bulk_modulus * (std::expm1((1.0 - exponent) * std::log1p(j)) / (exponent - 1.0) + j);
}

// j at depth h (m) below the surface; gravity in m/s². Above the surface (h ≤ 0) it is 0.
inline double hydrostatic_j(double h, double gravity, const WaterModel& water) {
    const double head = h > 0.0 ? water.density * gravity * h / water.bulk_modulus() : 0.0;
    return std::expm1(-std::log1p(head) / water.exponent);
}

}  // namespace tidewater::mpm
