#include "analysis/series.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

using namespace tidewater::analysis;
using std::numbers::pi;

namespace {

struct Series {
    std::vector<double> time, value;
};

Series sample(double end, double step, const std::function<double(double)>& function) {
    Series series;
    for (int i = 0; i * step <= end; ++i) {
        series.time.push_back(i * step);
        series.value.push_back(function(i * step));
    }
    return series;
}

}  // namespace

TEST_CASE("smoothing keeps a line, and of a sinusoid the share that its formula says") {
    const Series line = sample(10.0, 0.1, [](double t) { return 2.0 + 3.0 * t; });
    const auto smoothed_line = smooth(line.time, line.value, 0.31);
    for (std::size_t i = 20; i < 80; ++i) CHECK(smoothed_line[i] == doctest::Approx(line.value[i]));

    const double omega = 4.0;
    const Series wave = sample(10.0, 0.02, [&](double t) { return std::sin(omega * t); });
    const auto smoothed = smooth(wave.time, wave.value, 0.2);
    const double share = std::exp(-0.5 * omega * omega * 0.2 * 0.2);
    for (std::size_t i = 100; i < 400; ++i)
        CHECK(smoothed[i] == doctest::Approx(share * wave.value[i]).epsilon(1e-3));
}

TEST_CASE("smoothing leaves gaps where they are and does not spread them") {
    const std::vector<double> time{0.0, 1.0, 2.0, 3.0}, value{1.0, none, 1.0, 1.0};
    const auto smoothed = smooth(time, value, 1.0);
    CHECK(std::isnan(smoothed[1]));
    for (const std::size_t i : {0u, 2u, 3u}) CHECK(smoothed[i] == doctest::Approx(1.0));
    CHECK(smooth({}, {}, 1.0).empty());
    CHECK(smooth(time, value, 0.0)[3] == 1.0);
}

TEST_CASE("finds the vertex of a parabola between samples, even or not") {
    const auto parabola = [](double t) { return 5.0 - 2.0 * (t - 1.37) * (t - 1.37); };
    Series even = sample(3.0, 0.25, parabola);
    for (const double drop : {0.0, 0.5, 10.0}) {
        const Extremum crest = fit_crest(even.time, even.value, 5, drop);
        CHECK(crest.time == doctest::Approx(1.37));
        CHECK(crest.value == doctest::Approx(5.0));
    }
    const std::vector<double> time{0.9, 1.3, 2.2};
    std::vector<double> value;
    for (const double t : time) value.push_back(parabola(t));
    CHECK(fit_crest(time, value, 1, 0.0).time == doctest::Approx(1.37));
}

TEST_CASE("takes the sample itself where no parabola has a vertex") {
    const std::vector<double> time{0.0, 1.0, 2.0};
    CHECK(fit_crest(time, std::vector{3.0, 2.0, 1.0}, 0, 0.5).time == 0.0);
    CHECK(fit_crest(time, std::vector{1.0, 2.0, 3.0}, 2, 0.5).value == 3.0);
    CHECK(fit_crest(time, std::vector{2.0, 2.0, 2.0}, 1, 0.5).time == 1.0);
    CHECK(fit_crest(time, std::vector{none, 2.0, none}, 1, 0.5).value == 2.0);
    CHECK(fit_crest(std::vector{4.0}, std::vector{1.0}, 0, 0.5).time == 4.0);
}

TEST_CASE("the first crest is the first maximum that is no ripple") {
    const std::vector<double> value{0.0, 0.3, 0.25, none, 1.0, 0.5, 2.0, 0.0};
    CHECK(find_crest(value, 0, 0.1) == 4);
    CHECK(find_crest(value, 0, 0.01) == 1);
    CHECK(find_crest(value, 0, 0.6) == 6);
    CHECK(find_crest(value, 5, 0.1) == 6);
    CHECK(find_crest(value, 7, 0.1) == value.size());
    CHECK(find_crest({}, 0, 0.1) == 0);
}

TEST_CASE("the first passage is of either sign and lies between samples") {
    const std::vector<double> time{0.0, 1.0, 2.0};
    CHECK(first_passage(time, std::vector{0.0, 1.0, 2.0}, 0.5) == doctest::Approx(0.5));
    CHECK(first_passage(time, std::vector{0.0, 0.0, -1.0}, 0.5) == doctest::Approx(1.5));
    CHECK(first_passage(time, std::vector{none, 1.0, 2.0}, 0.5) == doctest::Approx(1.0));
    CHECK(std::isnan(first_passage(time, std::vector{0.1, -0.1, none}, 0.5)));
    CHECK(std::isnan(first_passage({}, {}, 0.5)));
}

TEST_CASE("zero-up-crossings are a period apart, and ripples do not count") {
    const auto ripple = [](double t) { return 0.02 * std::sin(50.0 * t); };
    const Series wave = sample(10.0, 0.01, [&](double t) { return -std::sin(pi * t) + ripple(t); });
    const auto crossings = zero_up_crossings(wave.time, wave.value, 0.1);
    REQUIRE(crossings.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(std::abs(crossings[i] - (1.0 + 2.0 * static_cast<double>(i))) < 0.02);
    }
    const Series still = sample(10.0, 0.01, ripple);
    CHECK(zero_up_crossings(still.time, still.value, 0.1).empty());
    CHECK(zero_up_crossings({}, {}, 0.1).empty());
}

TEST_CASE("a rise out of rest counts from where it passes the margin") {
    const std::vector<double> time{0.0, 1.0, 2.0, 3.0, 4.0}, value{0.01, 0.0, 1.0, -1.0, 1.0};
    const auto crossings = zero_up_crossings(time, value, 0.1);
    REQUIRE(crossings.size() == 2);
    CHECK(crossings[0] == doctest::Approx(1.1));
    CHECK(crossings[1] == doctest::Approx(3.5));
}
