#include "mpm/materials/ice_yield.h"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "unit/mpm/ice_support.h"

using namespace tidewater::mpm;
using namespace tidewater::mpm::ice_support;

namespace {

template <int D, class Real>
unsigned map(const IceModel& model, int count, Batch<D, Real>& batch) {
    return return_to_yield<D, Real>(IceConstants<D, Real>(model), count, batch.strain, &batch.alpha,
                                    batch.stress);
}

}  // namespace

TEST_CASE_TEMPLATE("any trial state comes back finite, positive definite, and on or inside its surface", Real,
                   float, double) {
    Random random(5);
    const auto check = [&]<int D>(std::integral_constant<int, D>) {
        const double eps = std::numeric_limits<Real>::epsilon();
        int tips = 0, shears = 0, elastic = 0;
        for (const double beta : {1.0, 0.2, 0.05})
            for (const bool cap : {true, false})
                for (int exponent = -14; exponent <= 10; ++exponent) {
                    IceModel model;
                    model.beta = beta;
                    model.cap_hardening = cap;
                    Batch<D, Real> batch;
                    for (int p = 0; p < batch_size; ++p) {
                        const double size = std::pow(10.0, 0.5 * exponent);
                        const Tensor<D> identity = Tensor<D>::Identity();
                        const Tensor<D> f = identity + random_tensor<D>(random, size);
                        batch.set(p, f * f.transpose() - identity);
                        const double alphas[] = {model.initial_alpha(D), 0.0, 0.3, -0.2, -1e-5};
                        batch.alpha[p] = static_cast<Real>(alphas[p % 5]);
                    }
                    const Batch<D, Real> before = batch;
                    CHECK((map<D, Real>(model, 64, batch) & ice_unusable) == 0);
                    for (int p = 0; p < batch_size; ++p) {
                        const Tensor<D> trial = before.strain_of(p), strain = batch.strain_of(p);
                        const bool moved = trial != strain;
                        const double p0 = p0_of<D>(model, static_cast<double>(before.alpha[p]));
                        const double was = pressure_of<D>(model, trial), now = pressure_of<D>(model, strain);
                        CAPTURE(trial);
                        CAPTURE(strain);
                        CAPTURE(p0);
                        REQUIRE(strain.allFinite());
                        REQUIRE(batch.stress_of(p).allFinite());
                        REQUIRE(std::isfinite(batch.alpha[p]));
                        if (!moved) {
                            elastic += 1;
                            CHECK(std::memcmp(&batch.alpha[p], &before.alpha[p], sizeof(Real)) == 0);
                        }
                        CHECK(is_positive_definite<D>(Tensor<D>::Identity() + strain));
                        const double q = q_of<D>(model, strain);
                        const double size = (1 + beta) * p0 + eps * model.bulk_modulus(D) * strain.norm();
                        CHECK(yield(model, now, q, p0) <= 200 * eps * 3 * size * size);
                        if (moved && strain.isDiagonal(0) && strain(0, 0) == strain(D - 1, D - 1))
                            tips += 1;
                        else if (moved && trial.norm() < 1) {
                            shears += 1;
                            const double rounding = 20 * eps * model.bulk_modulus(D) * trial.norm();
                            CHECK(std::abs(now - was) <= rounding);
                        }
                        // The stress is that of the returned strain.
                        const Tensor<D> exact = reference_stress<D>(model, strain);
                        CHECK((batch.stress_of(p) - exact).norm() <=
                              100 * eps * model.bulk_modulus(D) * strain.norm());
                    }
                }
        CHECK(tips > 500);
        CHECK(shears > 100);
        CHECK(elastic > 500);
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

TEST_CASE_TEMPLATE("elastic particles keep their bits beside ones that yield, and lanes beyond count too",
                   Real, float, double) {
    Random random(6);
    const IceModel model;
    for (const int count : {16, 64}) {
        Batch<3, Real> batch;
        for (int p = 0; p < batch_size; ++p) {
            batch.set(p, random_tensor<3>(random, 1e-7));
            batch.alpha[p] = static_cast<Real>(model.initial_alpha(3));
        }
        Batch<3, Real> before = batch;
        CHECK(map<3, Real>(model, count, batch) == 0);
        CHECK(std::memcmp(before.strain, batch.strain, sizeof batch.strain) == 0);
        Column<Real> stress[6] = {};
        ice_stress<3, Real>(IceConstants<3, Real>(model), batch.strain, count, stress);
        CHECK(std::memcmp(stress, batch.stress, sizeof stress) == 0);

        batch.strain[1][3] = Real(0.1);
        if (count < batch_size) batch.strain[1][count] = Real(0.1);
        before = batch;
        CHECK(map<3, Real>(model, count, batch) == ice_yielded);
        for (int p = 0; p < batch_size; ++p) {
            const bool same = before.strain_of(p) == batch.strain_of(p) && before.alpha[p] == batch.alpha[p];
            CHECK(same == (p != 3));
        }
    }
}

TEST_CASE("each of the three cases moves J, q and α as the formulas say") {
    IceModel model;
    model.beta = 0.2;
    model.cap_hardening = false;
    const double kappa = model.bulk_modulus(3), alpha0 = model.initial_alpha(3), p0 = p0_of<3>(model, alpha0);
    Batch<3, double> batch;
    const Tensor<3> identity = Tensor<3>::Identity();
    Tensor<3> shear = Tensor<3>::Zero();
    shear(0, 1) = shear(1, 0) = 0.02;
    batch.set(0, -0.01 * identity + 0.1 * shear);
    batch.set(1, 0.01 * identity + 0.1 * shear);
    batch.set(2, shear + 0.5 * shear * shear);  // p ≤ pc: softens
    batch.set(3, shear - 0.0015 * identity);    // p > pc: hardens
    for (int p = 0; p < batch_size; ++p) batch.alpha[p] = alpha0;
    const Batch<3, double> before = batch;
    CHECK(map<3, double>(model, 16, batch) == ice_yielded);

    const double tip_j2[] = {1 - 2 * p0 / kappa, 1 + 2 * model.beta * p0 / kappa};
    for (int p = 0; p < 2; ++p) {
        CHECK((batch.strain_of(p) - (std::cbrt(tip_j2[p]) - 1) * identity).norm() < 1e-14);
        const double trial_j2 = 1 + volume_of<3>(before.strain_of(p));
        CHECK(batch.alpha[p] ==
              doctest::Approx(alpha0 + 0.5 * std::log(trial_j2 / tip_j2[p])).epsilon(1e-12));
    }
    for (int p = 2; p < 4; ++p) {
        const Tensor<3> trial = before.strain_of(p), strain = batch.strain_of(p);
        const double pressure = pressure_of<3>(model, trial);
        CHECK((pressure > 0.5 * p0 * (1 - model.beta)) == (p == 3));
        CHECK(pressure_of<3>(model, strain) == doctest::Approx(pressure).epsilon(1e-9));
        const double room = (pressure + model.beta * p0) * (p0 - pressure) / (1 + 2 * model.beta);
        const double q_new = model.friction * std::sqrt(room), q = q_of<3>(model, trial);
        CHECK(q_of<3>(model, strain) == doctest::Approx(q_new).epsilon(1e-3));
        CHECK(q_of<3>(model, strain) <= q_new * (1 + 1e-12));
        const double j2 = 1 + volume_of<3>(trial);
        const auto z = [&](double of) {
            return std::sqrt(1 + of * std::cbrt(j2) / (model.shear_modulus() * std::sqrt(1.5)));
        };
        const double step = std::log(z(q) / z(q_new));
        CHECK(batch.alpha[p] == doctest::Approx(alpha0 + (p == 2 ? step : -step)).epsilon(1e-12));
    }
    // On its old surface now: mapped again with the old α nothing is left to do.
    batch.alpha = before.alpha;
    CHECK(map<3, double>(model, 16, batch) == 0);
}

TEST_CASE_TEMPLATE("failed ice keeps no stress, and opens and closes by ln J", Real, float, double) {
    const IceModel model;
    Random random(7);
    Batch<3, Real> batch;
    for (int p = 0; p < batch_size; ++p) {
        batch.set(p, random_tensor<3>(random, 1e-3));
        batch.alpha[p] = Real(0.1);
    }
    batch.set(5, Tensor<3>::Zero());
    const Batch<3, Real> before = batch;
    CHECK(map<3, Real>(model, 64, batch) == ice_yielded);
    for (int p = 0; p < batch_size; ++p) {
        CHECK(batch.strain_of(p).norm() == 0.0);
        CHECK(batch.stress_of(p).norm() == 0.0);
        const double opened = 0.5 * std::log1p(volume_of<3>(before.strain_of(p)));
        CHECK(batch.alpha[p] == doctest::Approx(0.1 + opened).epsilon(1e-6));
    }
}

TEST_CASE_TEMPLATE("hopeless strains are mended or reported, never passed on", Real, float, double) {
    IceModel model;
    model.beta = 1.0;
    Batch<3, Real> batch;
    for (int p = 0; p < 16; ++p) batch.alpha[p] = static_cast<Real>(model.initial_alpha(3));
    batch.set(0, -1.0 * Tensor<3>::Identity());
    batch.set(1, -5.0 * Tensor<3>::Identity());
    batch.set(2, 1e12 * Tensor<3>::Identity());
    batch.set(3, 1e10 * Tensor<3>::Ones());
    CHECK(map<3, Real>(model, 16, batch) == ice_yielded);
    for (int p = 0; p < 4; ++p) {
        CHECK(batch.strain_of(p).cwiseAbs().maxCoeff() < 2e-3);
        CHECK(std::abs(batch.alpha[p]) < 10);
    }
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()}) {
        batch.strain[1][7] = bad;
        CHECK((map<3, Real>(model, 16, batch) & ice_unusable) == ice_unusable);
    }
}

TEST_CASE("float follows double to failure at E = 10 GPa") {
    // Softening in shear is a snap, which amplifies any difference: there the step of the failure is
    // compared. Lane 0 is pulled alike on all sides, which softens stably at βξ < 1, and is compared all the
    // way.
    IceModel model;
    model.youngs_modulus = 1e10;
    model.beta = 0.2;
    model.hardening = 3.0;
    Random random(8);
    Batch<3, double> fine;
    Batch<3, float> coarse;
    Column<double> a_fine[9];
    Column<float> a_coarse[9];
    for (int p = 0; p < batch_size; ++p) {
        const Tensor<3> rate =
            p == 0 ? Tensor<3>(1e-7 * Tensor<3>::Identity()) : random_tensor<3>(random, 1e-7);
        for (int i = 0; i < 9; ++i) {
            a_coarse[i][p] = static_cast<float>(rate(i / 3, i % 3));
            a_fine[i][p] = static_cast<double>(a_coarse[i][p]);
        }
        coarse.alpha[p] = static_cast<float>(model.initial_alpha(3));
        fine.alpha[p] = static_cast<double>(coarse.alpha[p]);
    }
    const Column<double> start = fine.alpha;
    const double p0 = model.beta_p0 / model.beta, half_lost = 0.5 * model.initial_alpha(3);
    std::vector<int> fine_failed(batch_size, 0), coarse_failed(batch_size, 0);
    double elastic_error = 0.0, stable_error = 0.0;
    for (int n = 1; n <= 3000; ++n) {
        advance_strain<3, double>(a_fine, 64, fine.strain);
        advance_strain<3, float>(a_coarse, 64, coarse.strain);
        map<3, double>(model, 64, fine);
        map<3, float>(model, 64, coarse);
        for (int p = 0; p < batch_size; ++p) {
            const std::size_t lane = static_cast<std::size_t>(p);
            if (fine_failed[lane] == 0 && fine.alpha[p] > half_lost) fine_failed[lane] = n;
            if (coarse_failed[lane] == 0 && static_cast<double>(coarse.alpha[p]) > half_lost)
                coarse_failed[lane] = n;
            const double error = (fine.stress_of(p) - coarse.stress_of(p)).norm() / p0;
            if (p == 0) stable_error = std::max(stable_error, error);
            if (fine.alpha[p] == start[p]) elastic_error = std::max(elastic_error, error);
        }
    }
    int failed = 0;
    for (std::size_t p = 0; p < batch_size; ++p) {
        failed += fine_failed[p] != 0 ? 1 : 0;
        CHECK(std::abs(fine_failed[p] - coarse_failed[p]) <= 2);
    }
    CAPTURE(stable_error);
    CAPTURE(elastic_error);
    CHECK(failed > 32);
    CHECK(elastic_error < 1e-4);
    CHECK(stable_error < 1e-4);
}
