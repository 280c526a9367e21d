#include "analysis/oscillation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

struct Record {
    std::vector<double> time, value;
};

// 0.3 exp(−decay t) cos(ω t + 0.4) + 0.02 over ten periods, and noise.
Record record(double frequency, double decay, double noise) {
    Record all;
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.01 * i * 2.0 * 3.14159265358979 / frequency;
        all.time.push_back(t);
        all.value.push_back(0.3 * std::exp(-decay * t) * std::cos(frequency * t + 0.4) + 0.02 +
                            noise * (random_uniform(1, 0, static_cast<std::uint64_t>(i)) - 0.5));
    }
    return all;
}

}  // namespace

TEST_CASE("finds frequency and decay of a pure damped oscillation to rounding, from a guess off by a sixth") {
    for (const double decay : {0.0, 0.05, 0.6}) {
        const Record all = record(3.7, decay, 0.0);
        for (const double guess : {3.7, 3.2, 4.2}) {
            const Oscillation fit = fit_oscillation(all.time, all.value, guess);
            CHECK(fit.frequency == doctest::Approx(3.7).epsilon(1e-9));
            CHECK(std::abs(fit.decay - decay) < 1e-8);
            CHECK(fit.envelope(0.0) == doctest::Approx(0.3).epsilon(1e-8));
            CHECK(fit.offset == doctest::Approx(0.02).epsilon(1e-6));
            CHECK(fit.misfit < 1e-9);
        }
    }
}

TEST_CASE("noise of a tenth moves the frequency by less than a thousandth") {
    const Record all = record(3.7, 0.05, 0.06);
    const Oscillation fit = fit_oscillation(all.time, all.value, 3.5);
    CHECK(std::abs(fit.frequency / 3.7 - 1.0) < 1e-3);
    CHECK(std::abs(fit.decay - 0.05) < 5e-3);
    CHECK(fit.at(1.0) == doctest::Approx(0.3 * std::exp(-0.05) * std::cos(4.1) + 0.02).epsilon(0.05));
}

TEST_CASE("gaps are left out, and a record that is too short has no oscillation") {
    Record all = record(3.7, 0.05, 0.0);
    for (std::size_t i = 300; i < 400; ++i) all.value[i] = NAN;
    CHECK(fit_oscillation(all.time, all.value, 3.6).frequency == doctest::Approx(3.7).epsilon(1e-8));
    CHECK(std::isnan(fit_oscillation({}, {}, 1.0).frequency));
    CHECK(std::isnan(
        fit_oscillation(std::span(all.time).first(20), std::span(all.value).first(20), 3.7).decay));
}
