// Ice in plain double with Eigen, for ice_test.cpp and ice_yield_test.cpp: ice.h's formulas as they stand.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "mpm/materials/ice.h"

namespace tidewater::mpm::ice_support {

template <int D>
using Tensor = Eigen::Matrix<double, D, D>;
using Random = std::mt19937;

constexpr std::pair<int, int> places[2][6] = {{{0, 0}, {0, 1}, {1, 1}},
                                              {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

template <int D, class Real>
struct Batch {
    Column<Real> strain[symmetric_size<D>] = {}, stress[symmetric_size<D>] = {}, alpha = {};

    void set(int p, const Tensor<D>& value) {
        for (int c = 0; c < symmetric_size<D>; ++c)
            strain[c][p] = static_cast<Real>(value(places[D - 2][c].first, places[D - 2][c].second));
    }
    static Tensor<D> read(const Column<Real>* column, int p) {
        Tensor<D> value;
        for (int c = 0; c < symmetric_size<D>; ++c) {
            const auto [i, j] = places[D - 2][c];
            value(i, j) = value(j, i) = static_cast<double>(column[c][p]);
        }
        return value;
    }
    Tensor<D> strain_of(int p) const { return read(strain, p); }
    Tensor<D> stress_of(int p) const { return read(stress, p); }
};

template <int D>
Tensor<D> random_tensor(Random& random, double size) {
    std::normal_distribution<double> normal(0.0, size);
    return Tensor<D>::NullaryExpr([&] { return normal(random); });
}

// The formulas of ice.h's head in plain double.
template <int D>
double volume_of(const Tensor<D>& strain) {  // J² − 1
    if constexpr (D == 2) return strain.trace() + strain.determinant();
    return strain.trace() + 0.5 * (strain.trace() * strain.trace() - (strain * strain).trace()) +
           strain.determinant();
}
template <int D>
Tensor<D> reference_stress(const IceModel& model, const Tensor<D>& strain) {
    const Tensor<D> identity = Tensor<D>::Identity(), dev = strain - strain.trace() / D * identity;
    const double j2 = (identity + strain).determinant();
    return model.shear_modulus() * std::pow(j2, -1.0 / D) * dev +
           0.5 * model.bulk_modulus(D) * volume_of<D>(strain) * identity;
}
template <int D>
double pressure_of(const IceModel& model, const Tensor<D>& strain) {
    return -0.5 * model.bulk_modulus(D) * volume_of<D>(strain);
}
template <int D>
double q_of(const IceModel& model, const Tensor<D>& strain) {
    const Tensor<D> tau = reference_stress<D>(model, strain);
    return std::sqrt(0.5 * (6 - D)) * (tau + pressure_of<D>(model, strain) * Tensor<D>::Identity()).norm();
}
template <int D>
bool is_positive_definite(const Tensor<D>& b) {  // by its leading minors
    return b(0, 0) > 0 && b.template topLeftCorner<2, 2>().determinant() > 0 && b.determinant() > 0;
}
template <int D>
double p0_of(const IceModel& model, double alpha) {
    double angle = std::min(model.hardening * std::max(-alpha, 0.0), std::asinh(0.45));
    if (model.cap_hardening) angle = std::min(angle, -model.hardening * model.initial_alpha(D));
    return model.bulk_modulus(D) * std::sinh(angle);
}
inline double yield(const IceModel& model, double p, double q, double p0) {
    return q * q * (1 + 2 * model.beta) + model.friction * model.friction * (p + model.beta * p0) * (p - p0);
}

}  // namespace tidewater::mpm::ice_support
