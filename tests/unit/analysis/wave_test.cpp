#include "analysis/wave.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;
using std::numbers::pi;

namespace {

const WaveSettings settings{.depth = 1.0, .gravity = 9.81, .far_wall = 100.0, .smallest_amplitude = 0.002};

struct Record {
    std::vector<double> time, elevation;
    GaugeWave analyse(double x, const WaveSettings& with = settings) const {
        return analyse_gauge(x, time, elevation, with);
    }
};

Record record(double end, double step, const std::function<double(double)>& elevation) {
    Record made;
    for (int i = 0; i * step <= end; ++i) {
        made.time.push_back(i * step);
        made.elevation.push_back(elevation(i * step));
    }
    return made;
}

// A solitary wave of height a = 0.2 m on D = 1 m (Boussinesq) that passes x = 0 at t = 2 s with speed c.
double solitary(double x, double t, double c) {
    const double arch = 1.0 / std::cosh(std::sqrt(0.75 * 0.2) * (x - c * (t - 2.0)));
    return 0.2 * arch * arch;
}

// Uniform noise with the given greatest value.
double noise(double size, std::uint64_t stream, double t) {
    return size * (2.0 * random_uniform(3, stream, static_cast<std::uint64_t>(t * 1e6)) - 1.0);
}

std::vector<GaugeWave> pulse_at_gauges(double c, double noise_size) {
    std::vector<GaugeWave> gauges;
    for (const double x : {8.0, 10.0, 12.0, 14.0, 16.0}) {  // which the wave's front reaches after t = 0
        const auto stream = static_cast<std::uint64_t>(x);
        gauges.push_back(record(10.0, 0.01, [&](double t) {
                             return solitary(x, t, c) + noise(noise_size, stream, t);
                         }).analyse(x));
    }
    return gauges;
}

}  // namespace

TEST_CASE("a solitary wave's crest, amplitude and arrival are where they were put") {
    const double c = 3.4, x = 3.0;
    const GaugeWave wave = record(8.0, 0.013, [&](double t) { return solitary(x, t, c); }).analyse(x);
    CHECK(wave.crest_time == doctest::Approx(2.0 + x / c).epsilon(1e-3));
    CHECK(wave.crest == doctest::Approx(0.2).epsilon(0.01));
    CHECK(wave.greatest == doctest::Approx(wave.crest));
    CHECK(wave.greatest_time == doctest::Approx(wave.crest_time));
    CHECK(wave.height == doctest::Approx(0.2).epsilon(0.02));
    CHECK(std::isnan(wave.period));
    // sech²(θ) = 0.05 at θ = arcosh(√20)
    const double front = std::acosh(std::sqrt(20.0)) / std::sqrt(0.15) / c;
    CHECK(std::abs(wave.arrival - (2.0 + x / c - front)) < 0.02);
}

TEST_CASE("a pulse's speed is found from crests and from arrivals, with noise") {
    for (const double c : {2.5, 3.132, 3.5}) {
        CAPTURE(c);
        const auto still = pulse_at_gauges(c, 0.0);
        CHECK(celerity_overall(still).from_crests == doctest::Approx(c).epsilon(1e-3));
        CHECK(celerity_overall(still).from_arrivals == doctest::Approx(c).epsilon(1e-3));
        const auto noisy = pulse_at_gauges(c, 0.004);
        CHECK(celerity_overall(noisy).from_crests == doctest::Approx(c).epsilon(0.01));
        CHECK(celerity_overall(noisy).from_arrivals == doctest::Approx(c).epsilon(0.03));
        for (const Celerity& speed : celerity_between(noisy)) {
            CHECK(speed.from_crests == doctest::Approx(c).epsilon(0.04));
        }
    }
}

TEST_CASE("periodic waves give their period, height and trough, also as a sum of two sinusoids") {
    const auto two = [](double t) { return 0.1 * std::sin(pi * t) + 0.03 * std::sin(2.0 * pi * t); };
    const GaugeWave wave = record(20.0, 0.01, two).analyse(10.0);
    CHECK(wave.period == doctest::Approx(2.0).epsilon(0.02));
    CHECK(wave.mean_period == doctest::Approx(2.0).epsilon(0.01));
    double greatest = 0.0;
    for (double t = 0.0; t < 2.0; t += 1e-3) greatest = std::max(greatest, two(t));
    CHECK(wave.crest == doctest::Approx(greatest).epsilon(0.03));
    CHECK(wave.trough == doctest::Approx(-greatest).epsilon(0.03));
    CHECK(wave.lowest == doctest::Approx(-greatest).epsilon(0.03));
    CHECK(wave.height == doctest::Approx(2.0 * greatest).epsilon(0.03));
}

TEST_CASE("a leading trough arrives first, and the crest after it is the leading one") {
    const GaugeWave wave = record(10.0, 0.01, [](double t) {
                               return t < 1.0 ? 0.0 : -0.1 * std::sin(pi * (t - 1.0));
                           }).analyse(10.0);
    CHECK(wave.arrival == doctest::Approx(1.0).epsilon(0.05));
    CHECK(wave.crest_time == doctest::Approx(2.5).epsilon(0.01));
    CHECK(wave.period == doctest::Approx(2.0).epsilon(0.02));
}

TEST_CASE("a higher crest that comes back from the far wall is the record's greatest, not the leading wave's") {
    WaveSettings wall = settings;
    wall.far_wall = 10.0;
    const double c = std::sqrt(9.81), x = 4.0;
    const auto both = [&](double t) { return solitary(x, t, c) + 3.0 * solitary(20.0 - x, t, c); };
    const Record reflected = record(10.0, 0.01, both);
    const GaugeWave wave = reflected.analyse(x, wall);
    CHECK(wave.crest_time == doctest::Approx(2.0 + x / c).epsilon(0.01));
    CHECK(wave.crest == doctest::Approx(0.2).epsilon(0.02));
    CHECK(wave.greatest == doctest::Approx(0.6).epsilon(0.02));
    CHECK(wave.record_end < 2.0 + 16.0 / c);
}

TEST_CASE("noise around still water is no wave") {
    const GaugeWave wave = record(8.0, 0.01, [](double t) { return noise(0.0015, 1, t); }).analyse(3.0);
    CHECK(std::isnan(wave.arrival));
    CHECK(std::isnan(wave.crest));
    CHECK(wave.greatest < 0.002);
    CHECK(wave.record_end == doctest::Approx(8.0));
}

TEST_CASE("a still surface that is off by a constant changes no time and no height") {
    const auto at_level = [](double level) {
        return record(8.0, 0.01, [&](double t) { return level + solitary(3.0, t, 3.0); }).analyse(3.0);
    };
    const GaugeWave still = at_level(0.0);
    for (const double level : {-0.03, 0.03}) {
        const GaugeWave wave = at_level(level);
        CHECK(wave.arrival == doctest::Approx(still.arrival));
        CHECK(wave.crest_time == doctest::Approx(still.crest_time));
        CHECK(wave.height == doctest::Approx(still.height));
        CHECK(wave.crest == doctest::Approx(still.crest + level));
        CHECK(wave.lowest == doctest::Approx(still.lowest + level));
    }
    CHECK(std::isnan(record(8.0, 0.01, [](double) { return 0.03; }).analyse(3.0).arrival));
}

TEST_CASE("a wave that still rises at the end has arrived but has no crest") {
    const GaugeWave wave = record(2.0, 0.01, [](double t) { return 0.1 * t; }).analyse(3.0);
    CHECK(wave.arrival < 0.2);
    CHECK(std::isnan(wave.crest_time));
    CHECK(std::isnan(wave.height));
}

TEST_CASE("a record that ends between crest and trough has a crest but no height") {
    const auto falling =
        record(2.5, 0.01, [](double t) { return t < 0.5 ? 0.0 : 0.1 * std::sin(pi * (t - 0.5) / 1.6); });
    const GaugeWave wave = falling.analyse(5.0);
    CHECK(wave.crest == doctest::Approx(0.1).epsilon(0.02));
    CHECK(std::isnan(wave.trough));
    CHECK(std::isnan(wave.height));
}

TEST_CASE("empty, single and dry records hold nothing") {
    CHECK(std::isnan(Record{}.analyse(3.0).greatest));
    const GaugeWave one = Record{{1.0}, {0.05}}.analyse(3.0);
    CHECK(one.greatest == 0.05);
    CHECK(std::isnan(one.crest));
    const GaugeWave dry = record(2.0, 0.1, [](double) { return none; }).analyse(3.0);
    CHECK(std::isnan(dry.arrival));
    CHECK(std::isnan(dry.greatest));
    CHECK(std::isnan(dry.lowest));
}

TEST_CASE("a gap in the record does not hide the wave") {
    const GaugeWave wave = record(8.0, 0.01, [](double t) {
                               return t > 1.0 && t < 2.0 ? none : solitary(3.0, t, 3.0);
                           }).analyse(3.0);
    CHECK(wave.crest_time == doctest::Approx(3.0).epsilon(0.01));
}

TEST_CASE("celerity needs two gauges with times that increase") {
    CHECK(celerity_between({}).empty());
    CHECK(std::isnan(celerity_overall({}).from_crests));
    GaugeWave a, b;
    a.x = 1.0;
    a.crest_time = 2.0;
    b.x = 3.0;
    CHECK(std::isnan(celerity_overall(std::vector{a, b}).from_crests));
    b.crest_time = 2.0;
    CHECK(std::isnan(celerity_between(std::vector{a, b}).front().from_crests));
    b.crest_time = 3.0;
    CHECK(celerity_between(std::vector{a, b}).front().from_crests == doctest::Approx(2.0));
    CHECK(celerity_overall(std::vector{a, b}).from_crests == doctest::Approx(2.0));
    CHECK(long_wave_celerity(1.0, 9.81) == doctest::Approx(3.132).epsilon(1e-3));
}
