// Ice of the dense twin: lib/mpm/README.md, Ice, written down once more, one particle at a time, with b
// itself and the standard library's functions. Choices as documented in mpm/materials/ice.h; no code of
// mpm/materials/ice.cpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/types.h"
#include "mpm/materials/ice.h"

namespace tidewater::test {

// Turns the trial b and α into those on the yield surface.
template <int D>
void return_to_yield(const mpm::IceModel& ice, Matrix<D, double>& b, double& alpha) {
    const Matrix<D, double> one = Matrix<D, double>::Identity();
    const double mu = ice.shear_modulus(), kappa = ice.bulk_modulus(D), beta = ice.beta;
    const double alpha0 = -std::asinh(ice.beta_p0 / beta / kappa) / ice.hardening;
    const double j2 = b.determinant(), p = -kappa / 2 * (j2 - 1);
    const double p0 = std::min(kappa * std::sinh(ice.hardening * std::max(-alpha, 0.0)), 0.45 * kappa);
    const Matrix<D, double> dev = b - b.trace() / D * one;
    const double q = std::sqrt((6.0 - D) / 2) * mu * std::pow(j2, -1.0 / D) * dev.norm();
    const double m2 = ice.friction * ice.friction;
    if (p > p0 || p < -beta * p0) {
        const double tip = p > p0 ? 1 - 2 * p0 / kappa : 1 + 2 * beta * p0 / kappa;
        b = std::pow(tip, 1.0 / D) * one;
        alpha += std::log(std::sqrt(j2 / tip));
    } else if (q * q * (1 + 2 * beta) + m2 * (p + beta * p0) * (p - p0) > 0) {
        const double q_new = std::sqrt(m2 * (p + beta * p0) * (p0 - p) / (1 + 2 * beta));
        b = b.trace() / D * one + q_new / q * dev;
        b *= std::pow(j2 / b.determinant(), 1.0 / D);
        const double change = std::log((1 + dev.norm()) / (1 + q_new / q * dev.norm())) / 2;
        alpha += p <= p0 * (1 - beta) / 2 ? change : -change;
    } else {
        return;
    }
    if (ice.cap_hardening) alpha = std::max(alpha, alpha0);
}

// τ, Pa.
template <int D>
Matrix<D, double> kirchhoff_stress(const mpm::IceModel& ice, const Matrix<D, double>& b) {
    const Matrix<D, double> one = Matrix<D, double>::Identity();
    const double j2 = b.determinant();
    return ice.shear_modulus() * std::pow(j2, -1.0 / D) * (b - b.trace() / D * one) +
           ice.bulk_modulus(D) / 2 * (j2 - 1) * one;
}

}  // namespace tidewater::test
