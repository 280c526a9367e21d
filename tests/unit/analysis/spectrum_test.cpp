#include "analysis/spectrum.h"

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
Record sampled(int count, double step, const Eta& eta) {
    Record record;
    for (int i = 0; i < count; ++i) {
        record.time.push_back(i * step);
        record.value.push_back(eta(i * step));
    }
    return record;
}

// About the line of least squares.
double variance(const Record& record) {
    const double count = static_cast<double>(record.value.size()), middle = 0.5 * (count - 1.0);
    double mean = 0.0, slope = 0.0, squares = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < record.value.size(); ++i) {
        const double u = static_cast<double>(i) - middle;
        mean += record.value[i] / count;
        slope += u * record.value[i];
        squares += u * u;
    }
    for (std::size_t i = 0; i < record.value.size(); ++i)
        sum += std::pow(record.value[i] - mean - slope / squares * (static_cast<double>(i) - middle), 2);
    return sum / count;
}

double noise_value(std::mt19937& random) { return std::normal_distribution<double>(0.0, 0.5)(random); }

}  // namespace

TEST_CASE("the spectrum's integral is the record's variance, whatever the window and the segments") {
    std::mt19937 random(3);
    const Record record = sampled(1001, 0.05, [&](double t) { return 2.0 + 0.1 * t + noise_value(random); });
    for (const int segments : {1, 2, 7}) {
        for (const double taper : {0.0, 0.2, 1.0}) {
            const Spectrum spectrum = wave_spectrum(record.time, record.value, {segments, taper});
            CHECK(spectrum.moment(0) == doctest::Approx(variance(record)).epsilon(1e-12));
            CHECK(spectrum.frequency.back() == doctest::Approx(10.0));
        }
    }
}

TEST_CASE("without a window and of one segment that is Parseval's, with no scaling") {
    // Of a whole number of periods without trend: E of the even FFT bins is that of the plain periodogram.
    const Record record =
        sampled(256, 0.1, [](double t) { return std::cos(2 * pi * 8.0 * (t + 0.05) / 25.6); });
    const Spectrum spectrum = wave_spectrum(record.time, record.value, {1, 0.0});
    CHECK(spectrum.moment(0) == doctest::Approx(0.5).epsilon(1e-6));
    // A line of variance ½ has E = ½ N Δt at its frequency: 4 times padded, 32 bins from 0.
    CHECK(spectrum.frequency[32] == doctest::Approx(8.0 / 25.6));
    CHECK(spectrum.density[32] == doctest::Approx(0.5 * 25.6).epsilon(0.01));
}

TEST_CASE("a sinusoid gives back its height and period, between the bins too") {
    for (const double period : {1.7, 2.0, 2.345, 3.1}) {
        const Record record =
            sampled(1200, 0.05, [&](double t) { return 0.2 * std::sin(2 * pi * t / period); });
        const Spectrum spectrum = wave_spectrum(record.time, record.value);
        CHECK(spectrum.doubt.empty());
        CHECK(spectrum.peak_period() == doctest::Approx(period).epsilon(2e-3));
        CHECK(spectrum.significant_height() == doctest::Approx(4.0 * 0.2 / std::sqrt(2.0)).epsilon(0.02));
        CHECK(spectrum.mean_period() == doctest::Approx(period).epsilon(0.01));
        CHECK(spectrum.zero_crossing_period() == doctest::Approx(period).epsilon(0.01));
    }
}

TEST_CASE("of a sum of sinusoids the variances add up and the greatest gives the peak") {
    const Record record = sampled(4000, 0.05, [](double t) {
        return 0.1 * std::sin(2 * pi * t / 8.0) + 0.3 * std::sin(2 * pi * t / 5.0 + 1.0) +
               0.2 * std::sin(2 * pi * t / 3.0);
    });
    const Spectrum spectrum = wave_spectrum(record.time, record.value, {3, 1.0});
    CHECK(spectrum.significant_height() ==
          doctest::Approx(4.0 * std::sqrt((0.01 + 0.09 + 0.04) / 2.0)).epsilon(0.02));
    CHECK(spectrum.peak_period() == doctest::Approx(5.0).epsilon(5e-3));
    const double m1 = (0.01 / 8.0 + 0.09 / 5.0 + 0.04 / 3.0) / 0.14;
    CHECK(spectrum.mean_period() == doctest::Approx(1.0 / m1).epsilon(0.03));
}

TEST_CASE("more segments scatter less about the level of white noise") {
    std::mt19937 random(11);
    const Record record = sampled(8192, 0.1, [&](double) { return noise_value(random); });
    const auto scatter = [&](int segments) {
        const Spectrum spectrum = wave_spectrum(record.time, record.value, {segments, 1.0});
        double sum = 0.0, squares = 0.0, count = 0.0;
        for (std::size_t k = 10; k + 10 < spectrum.density.size(); ++k) {
            sum += spectrum.density[k];
            squares += spectrum.density[k] * spectrum.density[k];
            count += 1.0;
        }
        CHECK(sum / count == doctest::Approx(variance(record) / 5.0).epsilon(0.02));  // over 0 … 5 Hz
        return std::sqrt(squares / count - sum * sum / count / count) / (sum / count);
    };
    CHECK(scatter(1) == doctest::Approx(1.0).epsilon(0.1));
    CHECK(scatter(63) < 0.2);
}

TEST_CASE("uneven times and gaps are read as far as they go") {
    Record record = sampled(1200, 0.05, [](double t) { return 0.2 * std::sin(2 * pi * t / 2.0); });
    for (std::size_t i = 0; i < record.time.size(); ++i) {
        record.time[i] += 0.02 * std::sin(1.7 * static_cast<double>(i));
        record.value[i] = 0.2 * std::sin(2 * pi * record.time[i] / 2.0);
    }
    CHECK(wave_spectrum(record.time, record.value).peak_period() == doctest::Approx(2.0).epsilon(3e-3));
    record.value[50] = none;
    const Spectrum short_gap = wave_spectrum(record.time, record.value);
    CHECK(short_gap.peak_period() == doctest::Approx(2.0).epsilon(3e-3));
    CHECK(short_gap.from == record.time[51]);
    CHECK(short_gap.doubt.empty());
    record.value[500] = none;
    CHECK(wave_spectrum(record.time, record.value).doubt == "gaps take more than a tenth of the record");
}

TEST_CASE("records too short give no numbers, and the reason") {
    for (const int count : {0, 1, 2, 15}) {
        const Record record = sampled(count, 0.1, [](double t) { return std::sin(t); });
        const Spectrum spectrum = wave_spectrum(record.time, record.value);
        CHECK(spectrum.doubt == "fewer than 16 samples without a gap");
        CHECK(spectrum.frequency.empty());
        CHECK(std::isnan(spectrum.significant_height()));
        CHECK(std::isnan(spectrum.peak_period()));
        CHECK(std::isnan(spectrum.mean_period()));
    }
    const Record wave =
        sampled(200, 0.05, [](double t) { return std::sin(2 * pi * t / 9.0); });  // one period
    const Spectrum spectrum = wave_spectrum(wave.time, wave.value);
    CHECK(spectrum.doubt == "the record is too short for its longest waves");
    CHECK(std::isnan(spectrum.peak_period()));
    const Record dry = sampled(100, 0.1, [](double) { return none; });
    CHECK(wave_spectrum(dry.time, dry.value).frequency.empty());
}

TEST_CASE("a constant or straight record has no waves") {
    for (const double slope : {0.0, 0.3}) {
        const Record record = sampled(100, 0.1, [&](double t) { return 1.5 + slope * t; });
        const Spectrum spectrum = wave_spectrum(record.time, record.value);
        CHECK(spectrum.moment(0) < 1e-25);
        CHECK(!(spectrum.significant_height() > 1e-12));
        CHECK(std::isnan(spectrum.peak_period()) == !spectrum.doubt.empty());
    }
}
