#include "analysis/celerity_fit.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

constexpr double depth = 1.0, gravity = 9.81, interval = 0.01;
const double usual = std::sqrt(gravity * depth);
const std::vector<double> places{2.5, 3.5, 4.5, 5.5, 7.5, 9.5, 11.5};

struct Records {
    std::vector<double> time;
    std::vector<std::vector<double>> of_gauge;
};

// A surface height · exp(−x²/2w²) in an endless tank is let go at t = 0: Fourier's integral with
// ω² = (c²/D) k tanh(kD), and noise at every sample.
Records observe(double height, double width, double c, double noise, double end = 5.0) {
    constexpr double unit = 0.02;
    Records records;
    for (int i = 0; interval * i <= end; ++i) records.time.push_back(interval * i);
    for (std::size_t g = 0; g < places.size(); ++g) {
        auto& record = records.of_gauge.emplace_back(records.time.size(), 0.0);
        for (double k = 0.5 * unit; k < 8.0; k += unit) {
            const double omega = c * std::sqrt(k * std::tanh(k * depth) / depth);
            const double a = height * width * std::sqrt(2.0 / std::numbers::pi) * unit *
                             std::exp(-0.5 * k * k * width * width) * std::cos(k * places[g]);
            for (std::size_t i = 0; i < record.size(); ++i)
                record[i] += a * std::cos(omega * records.time[i]);
        }
        for (std::size_t i = 0; i < record.size(); ++i)
            record[i] += noise * (2.0 * random_uniform(1, g, i) - 1.0);
    }
    return records;
}

CelerityFit fit(const Records& records) {
    return fit_celerity(places, records.time, records.of_gauge, depth, gravity);
}

}  // namespace

TEST_CASE("dispersing humps and troughs give the speed of long waves, whatever part of them has passed") {
    for (const double height : {0.05, -0.003}) {
        for (const double width : {0.4, 0.8}) {
            for (const double end : {4.0, 5.0, 7.0}) {
                CAPTURE(width);
                const CelerityFit found = fit(observe(height, width, usual, 0.0, end));
                CHECK(found.celerity == doctest::Approx(usual).epsilon(0.003));
                CHECK(found.error < 0.005 * usual);
                CHECK(found.explained > 0.99);
                CHECK(found.pairs == 6);
            }
        }
    }
}

TEST_CASE("a speed that is not root g D is told as it is, with an error that covers it under noise") {
    for (const double share : {0.85, 1.1}) {
        const CelerityFit found = fit(observe(0.003, 0.6, share * usual, 0.0003));
        CHECK(std::abs(found.celerity - share * usual) < 0.02 * usual);
        CHECK(std::abs(found.celerity - share * usual) < 4.0 * found.error);
        CHECK(found.error < 0.02 * usual);
    }
}

TEST_CASE("noise, still water, a dry gauge and a single pair have no celerity") {
    Records noise = observe(0.0, 1.0, usual, 0.001), still = observe(0.0, 1.0, usual, 0.0);
    CHECK(std::isnan(fit(noise).celerity));
    CHECK(std::isnan(fit(still).celerity));
    Records dry = observe(0.05, 0.8, usual, 0.0);
    dry.of_gauge[3][7] = none;
    const CelerityFit rest = fit(dry);
    CHECK(rest.pairs == 4);
    CHECK(rest.celerity == doctest::Approx(usual).epsilon(0.003));
    for (const std::size_t gauges : {0u, 1u, 2u}) {
        const CelerityFit few = fit_celerity(std::span(places).first(gauges), dry.time,
                                             std::span(dry.of_gauge).first(gauges), depth, gravity);
        CHECK(few.pairs == (gauges == 2));
        CHECK(std::isnan(few.celerity));
    }
}
