#include "analysis/decay.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;

TEST_CASE("Student's quantiles are the tables'") {
    CHECK(student_quantile(1) == doctest::Approx(12.7062).epsilon(1e-5));
    CHECK(student_quantile(2) == doctest::Approx(4.30265).epsilon(1e-5));
    CHECK(student_quantile(3) == doctest::Approx(3.18245).epsilon(1e-5));
    CHECK(student_quantile(10) == doctest::Approx(2.22814).epsilon(1e-5));
    CHECK(student_quantile(30) == doctest::Approx(2.04227).epsilon(1e-5));
    CHECK(std::isnan(student_quantile(0)));
}

TEST_CASE("the decay of exact amplitudes comes back") {
    std::vector<double> r, a;
    for (const double x : {100.0, 250.0, 900.0, 4000.0, none, 500.0}) {
        r.push_back(x);
        a.push_back(x == 500.0 ? -1.0 : 27.0 * std::pow(x / 35.0, -5.0 / 6.0));
    }
    const AmplitudeDecay fit = fit_decay(r, a, 35.0);
    CHECK(fit.gauges == 4);
    CHECK(fit.exponent == doctest::Approx(5.0 / 6.0).epsilon(1e-12));
    CHECK(fit.amplitude == doctest::Approx(27.0).epsilon(1e-12));
    CHECK(fit.trustworthy());
}

TEST_CASE("the exponent's interval holds it in 95 of 100 records") {
    int held = 0;
    constexpr int records = 2000;
    for (std::uint64_t seed = 0; seed < records; ++seed) {
        std::vector<double> r, a;
        for (std::uint64_t i = 0; i < 6; ++i) {
            const double u = 1.0 - random_uniform(seed, 0, i), v = random_uniform(seed, 1, i);
            const double normal = std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * v);
            r.push_back(100.0 * std::pow(2.0, static_cast<double>(i)));
            a.push_back(5.0 * std::pow(r.back() / 50.0, -0.5) * std::exp(0.1 * normal));
        }
        const AmplitudeDecay fit = fit_decay(r, a, 50.0);
        held += fit.exponent_low <= 0.5 && 0.5 <= fit.exponent_high;
    }
    MESSAGE("coverage " << held / static_cast<double>(records));
    CHECK(held > 0.935 * records);
    CHECK(held < 0.965 * records);
}

TEST_CASE("a decay of few gauges or of growing waves is doubtful") {
    const std::array r{1.0, 2.0, 3.0, 4.0}, growing{1.0, 2.0, 2.5, 4.0};
    CHECK_FALSE(fit_decay(r, growing, 1.0).trustworthy());
    CHECK_FALSE(fit_decay(std::span(r).first(3), std::array{3.0, 2.0, 1.0}, 1.0).trustworthy());
    CHECK(std::isnan(fit_decay({}, {}, 1.0).exponent));
    CHECK(std::isnan(fit_decay(std::array{2.0, 2.0}, std::array{1.0, 3.0}, 1.0).exponent));
    CHECK(std::isnan(fit_decay(std::span(r).first(2), std::array{3.0, 2.0}, 1.0).exponent_low));
}

TEST_CASE("the run-up is the greatest height, when it is first reached") {
    const std::array t{0.0, 1.0, 2.0, 3.0}, z{none, 2.0, 2.0, -1.0};
    CHECK(greatest_run_up(t, z).time == 1.0);
    CHECK(greatest_run_up(t, z).value == 2.0);
    CHECK(std::isnan(greatest_run_up({}, {}).value));
}
