#include "analysis/first_wave.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "analysis/wave.h"
#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;
using std::numbers::pi;

namespace {

constexpr double depth = 1.0, gravity = 9.81, cell = 0.04;
const double celerity = long_wave_celerity(depth, gravity);

using Surface = std::function<double(double x, double t)>;

struct Tank {
    std::vector<double> x;
    std::vector<SurfaceProfile> profiles;

    FirstWave follow(double source, double wall) const {
        return follow_first_wave(
            x, profiles,
            {.depth = depth, .gravity = gravity, .cell_size = cell, .source = source, .wall = wall});
    }
};

// A place per cell; noise: greatest value, in cells, of each place and time on its own.
Tank observe(double length, double end, double interval, double noise, const Surface& surface) {
    Tank tank;
    for (double x = 0.5 * cell; x < length; x += cell) tank.x.push_back(x);
    for (std::uint64_t k = 0; static_cast<double>(k) * interval <= end; ++k) {
        SurfaceProfile profile{static_cast<double>(k) * interval, {}};
        for (std::size_t i = 0; i < tank.x.size(); ++i) {
            profile.elevation.push_back(surface(tank.x[i], profile.time) +
                                        noise * cell * (2.0 * random_uniform(1, k, i) - 1.0));
        }
        tank.profiles.push_back(profile);
    }
    return tank;
}

double sech2(double u) { return 1.0 / (std::cosh(u) * std::cosh(u)); }

// Linear waves of all lengths from a surface a exp(-x²/2s²) cos(kx) that is let go at t = 0: Fourier's
// integral of cos(ωt), ω² = gk tanh(kD).
class Release {
public:
    Release(double height, double width, double wavenumber = 0.0) {
        for (double k = 0.5 * step; k < 12.0; k += step) {
            const auto bell = [&](double at) { return std::exp(-0.5 * at * at * width * width); };
            k_.push_back(k);
            omega_.push_back(std::sqrt(gravity * k * std::tanh(k * depth)));
            spectrum_.push_back(height * width / std::sqrt(2.0 * pi) * step *
                                (bell(k - wavenumber) + bell(k + wavenumber)));
        }
    }

    double operator()(double x, double t) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < k_.size(); ++i)
            sum += spectrum_[i] * std::cos(k_[i] * x) * std::cos(omega_[i] * t);
        return sum;
    }

private:
    static constexpr double step = 0.05;
    std::vector<double> k_, omega_, spectrum_;
};

// The highest point of a surface within half a depth of x.
CrestPoint crest_near(const Surface& surface, double x, double t) {
    CrestPoint crest{.time = t, .amplitude = -1.0};
    for (double at = x - 0.5 * depth; at < x + 0.5 * depth; at += 0.005) {
        const double here = surface(at, t);
        if (here <= crest.amplitude) continue;
        crest.x = at;
        crest.amplitude = here;
    }
    return crest;
}

}  // namespace

TEST_CASE("a solitary wave is followed at its speed and height, with noise, either way") {
    const double c = 3.4;
    const Surface wave = [&](double x, double t) { return 0.2 * sech2(std::sqrt(0.15) * (x - 3.0 - c * t)); };
    for (const double noise : {0.0, 0.05}) {
        CAPTURE(noise);
        for (const bool leftward : {false, true}) {
            const Surface seen = leftward ? [&](double x, double t) { return wave(30.0 - x, t); } : wave;
            const FirstWave first =
                observe(30.0, 6.0, 0.1, noise, seen).follow(leftward ? 30.0 : 0.0, leftward ? 0.0 : 30.0);
            REQUIRE(first.track.size() > 40);
            CHECK(first.celerity == doctest::Approx(c).epsilon(0.005));
            CHECK(first.greatest.amplitude == doctest::Approx(0.2).epsilon(0.02));
            for (const CrestPoint& crest : first.track) {
                CHECK(std::abs(crest.distance - 3.0 - c * crest.time) < (noise > 0.0 ? 0.1 : 0.01));
                CHECK(crest.x == doctest::Approx(leftward ? 30.0 - crest.distance : crest.distance));
            }
        }
    }
}

TEST_CASE("the leading crest of a hump that disperses both ways is where Fourier's integral has it") {
    const double middle = 25.0;
    const Release hump(0.2, 0.5);
    const Surface surface = [&](double x, double t) { return hump(x - middle, t); };
    const Tank tank = observe(50.0, 6.0, 0.2, 0.02, surface);
    for (const double wall : {0.0, 50.0}) {
        CAPTURE(wall);
        const FirstWave wave = tank.follow(middle, wall);
        REQUIRE(wave.track.size() > 24);
        CHECK(wave.track.front().time <= 0.4);  // from the hump on
        for (const CrestPoint& crest : wave.track) {
            if (crest.time < 1.5) continue;
            CAPTURE(crest.time);
            const CrestPoint exact = crest_near(surface, crest.x, crest.time);
            CHECK(std::abs(crest.x - exact.x) < 0.1);
            CHECK(crest.amplitude == doctest::Approx(exact.amplitude).epsilon(0.04));
        }
        CHECK(wave.greatest.time < 1.0);
    }
}

TEST_CASE("a hump's leading crest nears Airy's, and its speed the long waves'") {
    const double hump_height = 0.4, width = 0.7;
    const Release hump(hump_height, width);
    const FirstWave wave =
        observe(60.0, 16.0, 0.5, 0.01, [&](double x, double t) { return hump(x, t); }).follow(0.0, 60.0);
    REQUIRE(wave.track.size() > 28);
    const CrestPoint& last = wave.track.back();
    // η = V/2 Ai((x - ct)/s)/s, s³ = cD²t/2, with its crest where Ai is greatest, 0.5357 at -1.0188.
    const double scale = std::cbrt(0.5 * celerity * depth * depth * last.time);
    const double half_volume = 0.5 * hump_height * width * std::sqrt(2.0 * pi);
    CHECK(last.distance == doctest::Approx(linear_crest_distance(depth, gravity, last.time)).epsilon(0.01));
    CHECK(last.amplitude == doctest::Approx(0.5357 * half_volume / scale).epsilon(0.05));
    const double linear = (linear_crest_distance(depth, gravity, last.time) -
                           linear_crest_distance(depth, gravity, wave.formed)) /
                          (last.time - wave.formed);
    CHECK(wave.celerity < celerity);
    CHECK(wave.celerity == doctest::Approx(linear).epsilon(0.01));
}

TEST_CASE("a linear wave's leading crest is slower than the long waves by what the header says") {
    for (const auto& [time, share] : {std::pair{1.5, 0.10}, {5.0, 0.04}}) {
        const double speed = (linear_crest_distance(depth, gravity, time + 0.01) -
                              linear_crest_distance(depth, gravity, time - 0.01)) /
                             0.02;
        CHECK(std::abs(1.0 - speed / celerity - share) < 0.005);
    }
}

TEST_CASE("higher crests behind and a splash beside the body do not lead") {
    const Release hump(0.1, 1.0), packet(0.25, 0.6, 4.0);
    const Surface surface = [&](double x, double t) {
        const double splash = 0.4 * std::exp(-x * x / 0.1) * std::abs(std::sin(7.0 * t));
        return hump(x, t) + packet(x, t) + splash;
    };
    const FirstWave wave = observe(30.0, 7.0, 0.1, 0.02, surface).follow(0.0, 30.0);
    REQUIRE(wave.track.size() > 40);
    for (const CrestPoint& crest : wave.track) {
        if (crest.time < 3.0) continue;
        const CrestPoint exact =
            crest_near([&](double x, double t) { return hump(x, t); }, crest.x, crest.time);
        CHECK(std::abs(crest.x - exact.x) < 0.2);
        CHECK(crest.distance > 0.7 * celerity * crest.time);
    }
    CHECK(wave.track.back().time == doctest::Approx(7.0));
}

TEST_CASE("what stays beside the body is not taken for where a low wave began") {
    // The hump is gone when the wave comes by.
    const Surface surface = [](double x, double t) {
        const double stays = t < 0.6 ? 0.1 * std::exp(-x * x / 0.2) : 0.0;
        return stays + 0.015 * std::exp(-std::pow((x + 1.2 - 3.0 * t) / 0.4, 2));
    };
    const FirstWave wave = observe(30.0, 5.0, 0.1, 0.02, surface).follow(0.0, 30.0);
    REQUIRE(wave.track.size() > 35);
    CHECK(wave.celerity == doctest::Approx(3.0).epsilon(0.01));
    for (const CrestPoint& crest : wave.track) CHECK(crest.amplitude < 0.02);
}

TEST_CASE("a forerunner a tenth as high does not lead") {
    const Surface surface = [](double x, double t) {
        return 0.1 * std::exp(-std::pow(x - 1.0 - 3.0 * t, 2)) +
               0.01 * std::exp(-std::pow((x - 5.0 - 3.3 * t) / 0.5, 2));
    };
    const FirstWave wave = observe(30.0, 5.0, 0.1, 0.02, surface).follow(0.0, 30.0);
    REQUIRE(wave.track.size() > 40);
    CHECK(wave.celerity == doctest::Approx(3.0).epsilon(0.01));
    for (const CrestPoint& crest : wave.track) CHECK(crest.amplitude > 0.05);
}

TEST_CASE("behind a trough that leads, the crest is followed") {
    const Release hollow(-0.2, 0.4);
    const Surface surface = [&](double x, double t) { return hollow(x, t); };
    const FirstWave wave = observe(30.0, 7.0, 0.1, 0.02, surface).follow(0.0, 30.0);
    REQUIRE(wave.track.size() > 30);
    const CrestPoint& last = wave.track.back();
    CHECK(std::abs(last.x - crest_near(surface, last.x, last.time).x) < 0.1);
    double lowest_ahead = 0.0;
    for (double x = last.x; x < 30.0; x += 0.1) lowest_ahead = std::min(lowest_ahead, surface(x, last.time));
    CHECK(lowest_ahead < -0.5 * last.amplitude);
}

TEST_CASE("the track ends before the far wall sends the wave back") {
    const double c = 3.2, wall = 16.0;
    const auto pulse = [](double d) { return 0.1 * std::exp(-d * d / 2.0); };
    const Surface surface = [&](double x, double t) {
        return pulse(x - 2.0 - c * t) + pulse(2.0 * wall - x - 2.0 - c * t);
    };
    const FirstWave wave = observe(wall, 8.0, 0.05, 0.02, surface).follow(0.0, wall);
    REQUIRE(!wave.track.empty());
    CHECK(wave.celerity == doctest::Approx(c).epsilon(0.01));
    CHECK(wave.track.back().distance > wall - 3.0);
    CHECK(wave.track.back().distance < wall - 1.0);
    for (const CrestPoint& crest : wave.track) CHECK(crest.amplitude == doctest::Approx(0.1).epsilon(0.04));
}

TEST_CASE("a hump that grows against a body and leaves it is followed from the beginning") {
    // The body covers 0 to 0.5; the crest stands at its side until 1 s.
    const Surface surface = [](double x, double t) {
        const double crest = 0.5 + std::max(0.0, 3.1 * (t - 1.0));
        const double height = 0.15 * std::min(t, 1.0) / std::sqrt(1.0 + 0.3 * std::max(0.0, t - 1.0));
        return x < 0.5 ? none : height * std::exp(-(x - crest) * (x - crest) / 2.0);
    };
    const FirstWave wave = observe(16.0, 4.0, 0.05, 0.02, surface).follow(0.0, 16.0);
    REQUIRE(wave.track.size() > 50);
    CHECK(wave.track.front().time < 0.2);
    CHECK(wave.track.front().distance < 0.7);
    CHECK(wave.greatest.amplitude == doctest::Approx(0.15).epsilon(0.04));
    CHECK(wave.greatest.time == doctest::Approx(1.0).epsilon(0.2));
    CHECK(wave.formed > 1.4);
    CHECK(wave.celerity == doctest::Approx(3.1).epsilon(0.01));
}

TEST_CASE("a level that was read too low is the same wave") {
    const Surface wave = [](double x, double t) { return 0.1 * std::exp(-std::pow(x - 2.0 - 3.0 * t, 2)); };
    const FirstWave right = observe(20.0, 4.0, 0.1, 0.0, wave).follow(0.0, 20.0);
    const FirstWave low = observe(20.0, 4.0, 0.1, 0.0, [&](double x, double t) {
                              return wave(x, t) - 0.3 * cell;
                          }).follow(0.0, 20.0);
    REQUIRE(low.track.size() == right.track.size());
    for (std::size_t i = 0; i < low.track.size(); ++i)
        CHECK(low.track[i].amplitude == doctest::Approx(right.track[i].amplitude));
}

TEST_CASE("noise, no water and no profiles hold no wave") {
    CHECK(observe(16.0, 3.0, 0.1, 0.05, [](double, double) { return 0.0; }).follow(0.0, 16.0).track.empty());
    CHECK(observe(16.0, 1.0, 0.1, 0.0, [](double, double) { return none; }).follow(0.0, 16.0).track.empty());
    const FirstWave nothing = Tank{}.follow(0.0, 16.0);
    CHECK(nothing.track.empty());
    CHECK(std::isnan(nothing.celerity));
    CHECK(std::isnan(nothing.greatest.amplitude));
    CHECK(std::isnan(amplitude_at(nothing, 2.0)));
}

TEST_CASE("the amplitude at a distance lies between the track's points, and is none beyond its ends") {
    FirstWave wave;
    wave.track = {{.time = 0.0, .x = 1.0, .distance = 1.0, .amplitude = 0.2},
                  {.time = 1.0, .x = 3.0, .distance = 3.0, .amplitude = 0.1}};
    CHECK(amplitude_at(wave, 2.0) == doctest::Approx(0.15));
    CHECK(amplitude_at(wave, 3.0) == doctest::Approx(0.1));
    CHECK(std::isnan(amplitude_at(wave, 3.1)));
    CHECK(std::isnan(amplitude_at(wave, 0.9)));
}
