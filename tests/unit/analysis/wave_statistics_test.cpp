#include "analysis/wave_statistics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace tidewater::analysis;

namespace {

constexpr double pi = std::numbers::pi;

struct Record {
    std::vector<double> time, value;
};

template <class Eta>
Record sampled(double duration, double step, const Eta& eta) {
    Record record;
    for (int i = 0; i * step < duration; ++i) {
        record.time.push_back(i * step);
        record.value.push_back(eta(i * step));
    }
    return record;
}

WaveStatistics statistics_of(const Record& record, double margin = 0.0) {
    return wave_statistics(
        zero_crossing_waves(record.time, record.value, mean_over_time(record.time, record.value), margin));
}

}  // namespace

TEST_CASE("a sinusoid has as many waves as whole periods, all of its height and period") {
    const Record record =
        sampled(21.0, 0.05, [](double t) { return 3.0 + 0.2 * std::sin(2 * pi * t / 2.0 - 1.0); });
    const auto waves = zero_crossing_waves(record.time, record.value, 3.0, 0.0);
    REQUIRE(waves.size() == 10);
    CHECK(waves.front().start == doctest::Approx(1.0 / pi).epsilon(0.01));
    for (const auto& wave : waves) {
        CHECK(wave.height() == doctest::Approx(0.4).epsilon(1e-3));
        CHECK(wave.period == doctest::Approx(2.0).epsilon(1e-3));
    }
    const WaveStatistics s = wave_statistics(waves);
    CHECK(s.significant_height == doctest::Approx(0.4).epsilon(1e-3));
    CHECK(s.greatest_height == doctest::Approx(0.4).epsilon(1e-3));
    CHECK(s.mean_period == doctest::Approx(2.0).epsilon(1e-3));
    CHECK(s.doubt == "fewer than 30 waves");
}

TEST_CASE("the significant height is the mean of the highest third") {
    std::vector<ZeroCrossingWave> waves;
    for (const double height : {1.0, 7.0, 3.0, 6.0, 2.0, 5.0, 4.0})  // of seven the three highest
        waves.push_back({0.0, 10.0 * height, 0.5 * height, -0.5 * height});
    const WaveStatistics s = wave_statistics(waves);
    CHECK(s.waves == 7);
    CHECK(s.significant_height == doctest::Approx(6.0));
    CHECK(s.significant_period == doctest::Approx(60.0));
    CHECK(s.greatest_height == doctest::Approx(7.0));
    CHECK(s.mean_height == doctest::Approx(4.0));
    CHECK(s.mean_period == doctest::Approx(40.0));
}

TEST_CASE("many sinusoids of random phase have Rayleigh's heights: four deviations") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> phase(0.0, 2 * pi);
    std::vector<double> phases(200);
    for (double& p : phases) p = phase(random);
    const double amplitude = 0.01;  // σ² = 200 a²/2
    const Record record = sampled(4000.0, 0.1, [&](double t) {
        double sum = 0.0;
        for (std::size_t i = 0; i < phases.size(); ++i)
            sum += amplitude * std::cos(2 * pi * (0.09 + 1e-4 * static_cast<double>(i)) * t + phases[i]);
        return sum;
    });
    const WaveStatistics s = statistics_of(record);
    CHECK(s.doubt.empty());
    CHECK(s.significant_height == doctest::Approx(4.0 * amplitude * 10.0).epsilon(0.05));
    CHECK(s.significant_height / s.mean_height == doctest::Approx(1.597).epsilon(0.05));
    CHECK(s.mean_period == doctest::Approx(1.0 / 0.1).epsilon(0.01));
}

TEST_CASE("ripples within the margin are no waves") {
    const auto ripples = [](double t) {
        return 0.5 * std::sin(2 * pi * t / 8.0) + 0.04 * std::sin(2 * pi * t / 0.3);
    };
    const Record record = sampled(41.0, 0.01, ripples);
    CHECK(statistics_of(record, 0.05).waves == 5);
    CHECK(statistics_of(record, 0.0).waves > 5);
}

TEST_CASE("a wave that comes to a gauge at rest counts from its first rise") {
    const Record record =
        sampled(20.0, 0.01, [](double t) { return t < 5.0 ? 0.0 : std::sin(pi * (t - 5.0) / 2.0); });
    const auto waves = zero_crossing_waves(record.time, record.value, 0.0, 0.05);
    REQUIRE(waves.size() == 3);
    CHECK(waves.front().start == doctest::Approx(5.0).epsilon(0.01));
    CHECK(waves.front().height() == doctest::Approx(2.0).epsilon(1e-3));
}

TEST_CASE("waves that a gap cuts do not count") {
    Record record =
        sampled(20.5, 0.05, [](double t) { return -std::sin(2 * pi * t / 2.0); });  // up at 1, 3, …
    CHECK(statistics_of(record).waves == 9);
    for (std::size_t i = 0; i < record.time.size(); ++i) {
        if (record.time[i] > 9.4 && record.time[i] < 9.6) record.value[i] = none;
    }
    const WaveStatistics s = statistics_of(record);
    CHECK(s.waves == 8);  // less the one from 9 to 11
    CHECK(s.mean_period == doctest::Approx(2.0).epsilon(1e-3));
}

TEST_CASE("records without waves tell why there are no numbers") {
    CHECK(wave_statistics({}).doubt == "no whole wave between zero-up-crossings");
    CHECK(std::isnan(wave_statistics({}).greatest_height));
    CHECK(statistics_of({}).waves == 0);
    CHECK(statistics_of({{0.0}, {1.0}}).waves == 0);
    CHECK(statistics_of({{0.0, 1.0}, {none, none}}).waves == 0);
    CHECK(statistics_of(sampled(10.0, 0.1, [](double) { return 0.3; })).waves == 0);
    const WaveStatistics two = statistics_of(sampled(5.6, 0.05, [](double t) { return -std::sin(pi * t); }));
    CHECK(two.waves == 2);
    CHECK(std::isnan(two.significant_height));
    CHECK(two.greatest_height == doctest::Approx(2.0).epsilon(0.01));
    CHECK(two.doubt == "fewer than 3 waves");
}

TEST_CASE("the mean over time weighs samples by the time between them and leaves gaps out") {
    CHECK(mean_over_time(std::vector{0.0, 1.0, 5.0}, std::vector{0.0, 2.0, 2.0}) ==
          doctest::Approx(9.0 / 5.0));
    CHECK(mean_over_time(std::vector{0.0, 1.0, 2.0, 3.0}, std::vector{1.0, 1.0, none, 9.0}) ==
          doctest::Approx(1.0));
    CHECK(mean_over_time(std::vector{1.0}, std::vector{4.0}) == 4.0);
    CHECK(std::isnan(mean_over_time({}, {})));
}
