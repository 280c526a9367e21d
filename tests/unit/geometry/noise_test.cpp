#include "geometry/noise.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/random.h"

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

constexpr std::uint64_t samples = 200'000;

std::array<double, 3> place(std::uint64_t n) {
    const auto along = [&](std::uint64_t axis) { return 400.0 * random_uniform(9, axis, n) - 200.0; };
    return {along(0), along(1), along(2)};
}

// Mean, RMS and greatest size of values at random places.
template <class Noise>
void check_spread(const Noise& noise, double rms) {
    double sum = 0.0, squares = 0.0, greatest = 0.0;
    for (std::uint64_t n = 0; n < samples; ++n) {
        const double value = noise(place(n));
        sum += value;
        squares += value * value;
        greatest = std::max(greatest, std::abs(value));
    }
    CHECK(std::abs(sum / samples) < 5.0 * rms / std::sqrt(samples));
    CHECK(std::abs(std::sqrt(squares / samples) - rms) < 0.01 * rms);
    CHECK(greatest <= 1.0);
    CHECK(greatest > 0.95);
}

// Value and slope, by central differences, on both sides of every place of a line change by what the second
// and third derivatives allow.
template <class Noise>
void check_smooth(const Noise& noise) {
    const double step = 1e-4;
    double greatest_jump = 0.0, greatest_kink = 0.0;
    for (int n = 0; n < 200'000; ++n) {
        const double at = n * step;
        const double a = noise(at), b = noise(at + step), c = noise(at + 2.0 * step),
                     d = noise(at + 3.0 * step);
        greatest_jump = std::max(greatest_jump, std::abs(b - a) / step);
        greatest_kink = std::max(greatest_kink, std::abs(d - 3.0 * c + 3.0 * b - a) / (step * step));
    }
    CHECK(greatest_jump < plane_noise_slope);
    CHECK(greatest_kink < 0.5);  // a change of the second derivative (about 100) within a step of 1e-4
}

}  // namespace

TEST_CASE("noise fills the range from -1 to 1 around 0, with the RMS stated") {
    check_spread([](const auto& p) { return simplex_noise(3, p[0], p[1]); }, plane_noise_rms);
    check_spread([](const auto& p) { return simplex_noise(3, p[0], p[1], p[2]); }, space_noise_rms);
}

TEST_CASE("noise is smooth: its value, slope and curvature do not jump") {
    check_smooth([](double t) { return simplex_noise(5, 0.8 * t, 3.0 + 0.6 * t); });
    check_smooth([](double t) { return simplex_noise(5, 0.8 * t - 7.0, 0.36 * t, 1.0 + 0.48 * t); });
}

TEST_CASE("the gradient of the noise in the plane stays below its bound") {
    const double step = 1e-6;
    double greatest = 0.0;
    for (std::uint64_t n = 0; n < samples; ++n) {
        const auto p = place(n);
        const double value = simplex_noise(3, p[0], p[1]);
        greatest = std::max(greatest, std::hypot(simplex_noise(3, p[0] + step, p[1]) - value,
                                                 simplex_noise(3, p[0], p[1] + step) - value) /
                                          step);
    }
    CHECK(greatest < plane_noise_slope);
    CHECK(greatest > 0.85 * plane_noise_slope);
}

TEST_CASE("noise rises through zero once per wavelength along a line, and forgets its value over one") {
    const double step = 0.02;
    const int lines = 100, steps = 10'000;
    std::array<int, 2> rises{};
    std::array<double, 2> products{};
    for (std::uint64_t line = 0; line < lines; ++line) {
        const auto from = place(line);
        const double turn = 2.0 * std::numbers::pi * random_uniform(9, 3, line);
        const double up = 2.0 * random_uniform(9, 4, line) - 1.0, level = std::sqrt(1.0 - up * up);
        const auto values = [&](double way) {
            const double c = std::cos(turn) * way, s = std::sin(turn) * way;
            return std::array{simplex_noise(3, from[0] + c, from[1] + s),
                              simplex_noise(3, from[0] + level * c, from[1] + level * s, from[2] + up * way)};
        };
        auto before = values(0.0);
        for (int n = 1; n <= steps; ++n) {
            const auto now = values(n * step), later = values(n * step + 1.0);
            for (std::size_t kind = 0; kind < 2; ++kind) {
                rises[kind] += before[kind] < 0.0 && now[kind] >= 0.0;
                products[kind] += now[kind] * later[kind];
            }
            before = now;
        }
    }
    for (const int count : rises) CHECK(count == doctest::Approx(lines * steps * step).epsilon(0.03));
    CHECK(std::abs(products[0] / (lines * steps)) < 0.1 * plane_noise_rms * plane_noise_rms);
    CHECK(std::abs(products[1] / (lines * steps)) < 0.1 * space_noise_rms * space_noise_rms);
}

TEST_CASE("the same seed gives the same noise, another one independent noise") {
    double product = 0.0;
    for (std::uint64_t n = 0; n < samples; ++n) {
        const auto p = place(n);
        const double value = simplex_noise(1, p[0], p[1], p[2]);
        if (n < 100) CHECK(value == simplex_noise(1, p[0], p[1], p[2]));
        product += value * simplex_noise(2, p[0], p[1], p[2]);
    }
    CHECK(std::abs(product / samples) < 5.0 * space_noise_rms * space_noise_rms / std::sqrt(samples));
}
