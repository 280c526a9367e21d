// Wolper et al. (2021), eqs. 2–4; ice.h gives the formulas.
//
// Loops have no branches, so that compilers put one particle into each lane. `__restrict` and local copies of
// the constants save run-time checks for overlap. Flags are or-ed integers, because a floating-point
// reduction would have to keep its order.
#include "mpm/materials/ice.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/materials/ice_lane.h"

namespace tidewater::mpm {

using namespace ice_lane;

double IceModel::bulk_modulus(int dimension) const {
    const bool slice = dimension == 2 && moduli == Moduli::plane_strain;
    return lame_lambda() + (slice ? 1.0 : 2.0 / 3.0) * shear_modulus();
}

double IceModel::wave_speed(int dimension) const {
    const double stiffness = bulk_modulus(dimension) + (dimension == 3 ? 4.0 / 3.0 : 1.0) * shear_modulus();
    return std::sqrt(stiffness / density);
}

double IceModel::initial_alpha(int dimension) const {
    return -std::asinh(beta_p0 / beta / bulk_modulus(dimension)) / hardening;
}

// The positive root of [(1+2β) + M²/d²] σ² + M² (1−β)(p0/d) σ − M² β p0² = 0.
double IceModel::uniaxial_strength(int dimension) const {
    const double d = dimension, m2 = friction * friction, p0 = beta_p0 / beta;
    const double a = 1 + 2 * beta + m2 / (d * d), b = m2 * (1 - beta) * p0 / d, c = -m2 * beta_p0 * p0;
    return -2 * c / (b + std::sqrt(b * b - 4 * a * c));
}

double crack_band_hardening(const IceModel& model, int dimension, double energy, double width) {
    const double range = std::asinh(model.beta_p0 / model.beta / model.bulk_modulus(dimension));
    const double deviator = model.uniaxial_strength(dimension) / std::sqrt((6.0 - dimension) / 2);  // |s|
    return 0.5 * width * deviator * range / energy;
}

template <int D, class Real>
IceConstants<D, Real>::IceConstants(const IceModel& model) {
    const double ratio = model.shear_modulus() / model.bulk_modulus(D);
    const double angle = -model.hardening * model.initial_alpha(D);
    mu = static_cast<Real>(model.shear_modulus());
    half_kappa = static_cast<Real>(0.5 * model.bulk_modulus(D));
    q2_factor = static_cast<Real>(0.5 * (6 - D) * ratio * ratio);
    one_plus_two_beta = static_cast<Real>(1 + 2 * model.beta);
    beta = static_cast<Real>(model.beta);
    friction2 = static_cast<Real>(model.friction * model.friction);
    xi = static_cast<Real>(model.hardening);
    min_alpha = static_cast<Real>(model.cap_hardening ? model.initial_alpha(D) : -1e6);
    keep_trace = model.shear_return == ShearReturn::trace;
    const double limit = std::asinh(0.45);
    max_angle = static_cast<Real>(model.cap_hardening ? std::min(angle, limit) : limit);
}

template <int D, class Real>
void advance_strain(const Column<Real>* __restrict increment, int count, Column<Real>* __restrict strain) {
    assert(is_batch(count));
    for (int p = 0; p < count; ++p) {
        // GCC does not vectorise over particles unless the small inner loops are unrolled.
        const auto a = [&](int i, int j) { return increment[i * D + j][p]; };
        const auto b = [&](int i, int j) { return strain[column<D>(i, j)][p]; };
        Real m[D][D];
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i)
#pragma GCC unroll 3
            for (int j = 0; j < D; ++j) {
                m[i][j] = a(i, j);
#pragma GCC unroll 3
                for (int k = 0; k < D; ++k) m[i][j] += a(i, k) * b(k, j);
            }
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i)
#pragma GCC unroll 3
            for (int j = i; j < D; ++j) {
                Real sum = m[i][j] + m[j][i];
#pragma GCC unroll 3
                for (int k = 0; k < D; ++k) sum += m[i][k] * a(j, k);
                strain[column<D>(i, j)][p] += sum;
            }
    }
}

template <int D, class Real>
unsigned ice_stress(const IceConstants<D, Real>& ice, const Column<Real>* __restrict strain, int count,
                    Column<Real>* __restrict kirchhoff) {
    assert(is_batch(count));
    const Real mu = ice.mu, half_kappa = ice.half_kappa;
    unsigned unusable = 0;
    for (int p = 0; p < count; ++p) {
        const Split<D, Real> b = split<D>(strain, p);
        const Real clamped = clamp_volume(b.volume);
        store_stress(b, mu * inverse_stretch2<D>(clamped), half_kappa * b.volume, kirchhoff, p);
        unusable |= static_cast<unsigned>(!(clamped == b.volume));
    }
    return unusable != 0 ? ice_unusable : 0u;
}

template <int D>
void ice_energy(const IceModel& model, const Column<double>* __restrict strain, Column<double>& energy) {
    const double half_mu = 0.5 * model.shear_modulus() * D, quarter_kappa = 0.25 * model.bulk_modulus(D);
    for (int p = 0; p < batch_size; ++p) {
        const Split<D, double> b = split<D>(strain, p);
        energy[p] = half_mu * shear_stretch(b) + quarter_kappa * (b.volume - lane_log1p(b.volume));
    }
}

template <int D>
double ice_energy(const IceModel& model, const std::array<double, symmetric_size<D>>& strain) {
    Column<double> columns[symmetric_size<D>]{}, energy;
    for (std::size_t c = 0; c < strain.size(); ++c) columns[c][0] = strain[c];
    ice_energy<D>(model, columns, energy);
    return energy[0];
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                            \
    template struct IceConstants<D, Real>;                                                        \
    template void advance_strain<D, Real>(const Column<Real>*, int, Column<Real>*);               \
    template unsigned ice_stress<D, Real>(const IceConstants<D, Real>&, const Column<Real>*, int, \
                                          Column<Real>*);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)
template void ice_energy<2>(const IceModel&, const Column<double>*, Column<double>&);
template void ice_energy<3>(const IceModel&, const Column<double>*, Column<double>&);
template double ice_energy<2>(const IceModel&, const std::array<double, 3>&);
template double ice_energy<3>(const IceModel&, const std::array<double, 6>&);

}  // namespace tidewater::mpm
