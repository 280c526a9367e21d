#include "mpm/materials/ice.h"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <type_traits>
#include <vector>

#include "unit/mpm/ice_support.h"

using namespace tidewater::mpm;
using namespace tidewater::mpm::ice_support;

TEST_CASE("ice has the wave speeds of 3D and of the plane") {
    IceModel model;
    CHECK(model.wave_speed(3) == doctest::Approx(1223.0).epsilon(1e-3));
    CHECK(model.wave_speed(2) == doctest::Approx(1223.0).epsilon(1e-3));  // plane strain: as in 3D
    model.moduli = Moduli::paper;
    CHECK(model.wave_speed(2) == doctest::Approx(1163.0).epsilon(1e-3));
    CHECK(model.wave_speed(3) == doctest::Approx(1223.0).epsilon(1e-3));
    model.youngs_modulus = 1e10;
    CHECK(model.wave_speed(3) == doctest::Approx(3867.0).epsilon(1e-3));
    CHECK(model.lame_lambda() + 2 * model.shear_modulus() / 3 == doctest::Approx(model.bulk_modulus(3)));
}

TEST_CASE_TEMPLATE("the strain advances as (I+A) b (I+A)ᵀ − I, and only in the lanes asked for", Real, float,
                   double) {
    Random random(1);
    const auto check = [&]<int D>(std::integral_constant<int, D>) {
        for (const int count : {0, 16, 64}) {
            Batch<D, Real> batch;
            Column<Real> increment[D * D];
            std::vector<Tensor<D>> expected;
            for (int p = 0; p < batch_size; ++p) {
                batch.set(p, random_tensor<D>(random, 0.2));
                Tensor<D> a;
                for (int i = 0; i < D * D; ++i) {
                    increment[i][p] = static_cast<Real>(std::normal_distribution<double>(0, 0.3)(random));
                    a(i / D, i % D) = static_cast<double>(increment[i][p]);
                }
                const Tensor<D> identity = Tensor<D>::Identity(), g = identity + a;
                expected.push_back(batch.strain_of(p));
                if (p < count) expected.back() = g * (identity + expected.back()) * g.transpose() - identity;
            }
            advance_strain<D, Real>(increment, count, batch.strain);
            double largest = 0.0;
            for (int p = 0; p < batch_size; ++p)
                largest = std::max(
                    largest,
                    (batch.strain_of(p) - expected[static_cast<std::size_t>(p)]).cwiseAbs().maxCoeff());
            CHECK(largest < 50 * std::numeric_limits<Real>::epsilon());
        }
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

TEST_CASE("float keeps the digits of J² − 1 and of the shear at strains of 1e-6") {
    Random random(2);
    const IceModel model;
    Batch<3, float> batch;
    for (int p = 0; p < batch_size; ++p)
        batch.set(
            p, p < 32 ? random_tensor<3>(random, 1e-6) : (1e-6 * (p - 31.0) * Tensor<3>::Identity()).eval());
    CHECK(ice_stress<3, float>(IceConstants<3, float>(model), batch.strain, 64, batch.stress) == 0);
    for (int p = 0; p < batch_size; ++p) {
        const Tensor<3> strain = batch.strain_of(p), exact = reference_stress<3>(model, strain);
        CHECK((batch.stress_of(p) - exact).norm() < 1e-6 * exact.norm());
        if (p < 32) continue;
        const double volume = batch.stress_of(p).trace() / 3 / (0.5 * model.bulk_modulus(3));
        CHECK(volume == doctest::Approx(volume_of<3>(strain)).epsilon(1e-6));
    }
}

TEST_CASE_TEMPLATE("elastic stress is the closed form for any strain, and zero for none", Real, float,
                   double) {
    Random random(3);
    const IceModel model;
    const auto check = [&]<int D>(std::integral_constant<int, D>) {
        for (const double size : {1e-7, 1e-4, 1e-2, 0.3}) {
            Batch<D, Real> batch;
            for (int p = 1; p < batch_size; ++p) {
                const Tensor<D> f = Tensor<D>::Identity() + random_tensor<D>(random, size);
                if (f.determinant() > 0.1) batch.set(p, f * f.transpose() - Tensor<D>::Identity());
            }
            CHECK(ice_stress<D, Real>(IceConstants<D, Real>(model), batch.strain, 64, batch.stress) == 0);
            CHECK(batch.stress_of(0).cwiseAbs().maxCoeff() == 0.0);
            for (int p = 1; p < batch_size; ++p) {
                const Tensor<D> exact = reference_stress<D>(model, batch.strain_of(p));
                const double scale = exact.norm() + model.bulk_modulus(D) * batch.strain_of(p).norm();
                CHECK((batch.stress_of(p) - exact).norm() <=
                      30 * std::numeric_limits<Real>::epsilon() * scale);
                const Tensor<D> b = Tensor<D>::Identity() + batch.strain_of(p);
                CHECK(volume_of<D>(batch.strain_of(p)) ==
                      doctest::Approx(b.determinant() - 1).epsilon(1e-12).scale(1e3));
            }
        }
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

TEST_CASE("isotropic strain gives only pressure, and simple shear γ gives τ_xy = μγ") {
    const IceModel model;
    Batch<3, double> batch;
    batch.set(0, (std::pow(1.1, 2.0 / 3) - 1) * Tensor<3>::Identity());
    const double gamma = 0.2;
    Tensor<3> shear = Tensor<3>::Zero();
    shear(0, 0) = gamma * gamma;
    shear(0, 1) = shear(1, 0) = gamma;
    batch.set(1, shear);
    ice_stress<3, double>(IceConstants<3, double>(model), batch.strain, 16, batch.stress);
    const Tensor<3> swollen = batch.stress_of(0), sheared = batch.stress_of(1);
    CHECK((swollen - 0.5 * model.bulk_modulus(3) * 0.21 * Tensor<3>::Identity()).norm() < 1e-6);
    CHECK(sheared(0, 1) == doctest::Approx(model.shear_modulus() * gamma));
    CHECK(sheared(0, 0) == doctest::Approx(model.shear_modulus() * gamma * gamma * 2 / 3));
    CHECK(sheared.trace() == doctest::Approx(0.0).scale(model.shear_modulus() * 1e-9));
}

TEST_CASE_TEMPLATE("the Kirchhoff stress is 2 ∂W/∂b b", Dimension, std::integral_constant<int, 2>,
                   std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    Random random(4);
    const IceModel model;
    const double h = 1e-5;
    Batch<D, double> batch;
    for (int p = 0; p < 16; ++p) {
        const Tensor<D> f = Tensor<D>::Identity() + random_tensor<D>(random, 0.1);
        batch.set(p, f * f.transpose() - Tensor<D>::Identity());
    }
    ice_stress<D, double>(IceConstants<D, double>(model), batch.strain, 16, batch.stress);
    for (int p = 0; p < 16; ++p) {
        std::array<double, symmetric_size<D>> strain;
        for (int c = 0; c < symmetric_size<D>; ++c) strain[static_cast<std::size_t>(c)] = batch.strain[c][p];
        Tensor<D> slope;
        for (int c = 0; c < symmetric_size<D>; ++c) {
            auto more = strain, less = strain;
            more[static_cast<std::size_t>(c)] += h;
            less[static_cast<std::size_t>(c)] -= h;
            const double rise = (ice_energy<D>(model, more) - ice_energy<D>(model, less)) / (2 * h);
            const auto [i, j] = places[D - 2][c];
            slope(i, j) = slope(j, i) = i == j ? rise : 0.5 * rise;  // an off-diagonal column moves b twice
        }
        const Tensor<D> expected = 2 * slope * (Tensor<D>::Identity() + batch.strain_of(p));
        CHECK((batch.stress_of(p) - expected).norm() < 1e-7 * model.bulk_modulus(D));
    }
    CHECK(ice_energy<D>(model, {}) == 0.0);
}

TEST_CASE("the stored energy is that of linear elasticity at a strain of 1e-7") {
    const IceModel model;
    const double e = 1e-7;  // b − I = 2e I: volumetric strain 3e
    CHECK(ice_energy<3>(model, {2 * e, 0, 0, 2 * e, 0, 2 * e}) ==
          doctest::Approx(4.5 * model.bulk_modulus(3) * e * e).epsilon(1e-5));
    CHECK(ice_energy<3>(model, {0, 2 * e, 0, 0, 0, 0}) ==
          doctest::Approx(2 * model.shear_modulus() * e * e).epsilon(1e-5));
}

TEST_CASE("elastic ice reports inverted and infinite strains") {
    const IceConstants<2, float> constants{IceModel{}};
    for (const float bad : {-1.0f, -3.0f, 1e6f, std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()}) {
        Batch<2, float> batch;
        batch.strain[0][15] = bad;
        CHECK(ice_stress<2, float>(constants, batch.strain, 16, batch.stress) == ice_unusable);
    }
}

TEST_CASE("the uniaxial strength is that told in lib/mpm/README.md") {
    IceModel model;
    const struct { double beta, in_2d, in_3d; } rows[] = {{1.0, 0.375e6, 0.390e6}, {0.5, 0.537e6, 0.595e6}};
    for (const auto& row : rows) {
        model.beta = row.beta;
        CHECK(model.uniaxial_strength(2) == doctest::Approx(row.in_2d).epsilon(2e-3));
        CHECK(model.uniaxial_strength(3) == doctest::Approx(row.in_3d).epsilon(2e-3));
    }
    for (const auto& [beta, ratio] : {std::pair{0.05, 1.82}, {0.12, 1.63}}) {
        model.beta = beta;
        CHECK(model.uniaxial_strength(2) / model.beta_p0 == doctest::Approx(ratio).epsilon(5e-3));
    }
}
