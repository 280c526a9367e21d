// The ends of a wave flume: finer cells, and trains of waves. Water 1 m deep, sound at 30 m/s.
#include <doctest/doctest.h>

#include <initializer_list>
#include <numeric>
#include <utility>

#include "support/wave_tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double interval = 0.05;  // s

// Amplitude of the part of the last `periods` that has this period.
double harmonic(const std::vector<double>& levels, double period, int periods) {
    const auto count = static_cast<std::size_t>(std::lround(periods * period / interval));
    double cosine = 0.0, sine = 0.0;
    for (std::size_t n = levels.size() - count; n < levels.size(); ++n) {
        const double phase = 2.0 * std::numbers::pi * static_cast<double>(n) * interval / period;
        cosine += 2.0 * levels[n] * std::cos(phase) / static_cast<double>(count);
        sine += 2.0 * levels[n] * std::sin(phase) / static_cast<double>(count);
    }
    return std::hypot(cosine, sine);
}

// Of waves of this period on 1 m of water, rad/m.
double wavenumber(double period) {
    const double omega = 2.0 * std::numbers::pi / period;
    double k = omega;
    for (int n = 0; n < 200; ++n) k = 0.5 * (k + omega * omega / (9.81 * std::tanh(k)));
    return k;
}

// What the window of level_at keeps of the amplitude of waves.
double kept_by_window(double k) {
    const double reach = 0.4, bend = k * reach / std::numbers::pi;
    return std::sin(k * reach) / (k * reach) / (1.0 - bend * bend);
}

}  // namespace

TEST_CASE("wider sponges and finer cells absorb a solitary wave") {
    for (const auto& [width, cells] : {std::pair{10.0, 12}, {6.0, 20}}) {
        const auto echo = test::echo_of(width, cells);
        MESSAGE(width, " D of sponge, ", cells, " cells: crest ", 100.0 * echo.crest, " %, trough ",
                100.0 * echo.trough, " %, level at the end ", 100.0 * echo.last, " %, water taken ",
                100.0 * echo.taken, " % of the wave's");
        CHECK(echo.crest <= 0.03);
        CHECK(echo.trough >= -0.03);
        CHECK(echo.taken == doctest::Approx(1.0).epsilon(0.05));
    }
}

// Height by the linear theory of the wave maker (mpm/boundaries/piston.h). What a sponge of 10 D sends back
// makes heights differ along the flume.
TEST_CASE("a piston in sine motion makes waves of the linear theory's height, and a sponge takes them") {
    const double amplitude = 0.03;
    for (const double period : {2.0, 3.0}) {
        const double k = wavenumber(period);
        const double theory =
            2.0 * amplitude * (std::cosh(2.0 * k) - 1.0) / (std::sinh(2.0 * k) + 2.0 * k) * kept_by_window(k);
        auto s = make_simulation<2, float>(test::piston_start(
            20.0, 16,
            {.motion = PistonMotion::sine, .amplitude = amplitude, .period = period, .ramp = 2.0 * period},
            10.0));
        const auto levels = test::record_levels({4.0, 5.0, 6.0, 7.0}, interval, 30.0, s);
        double least = 1e9, most = 0.0, mean = 0.0, level = 0.0;
        for (const auto& at : levels) {
            const double share = harmonic(at, period, 4) / theory;
            least = std::min(least, share);
            most = std::max(most, share);
            mean += 0.25 * share;
            const auto count = static_cast<std::ptrdiff_t>(std::lround(4.0 * period / interval));
            level += 0.25 * std::accumulate(at.end() - count, at.end(), 0.0) / static_cast<double>(count);
        }
        const double echo = (most - least) / (most + least);
        MESSAGE("period ", period, " s, kD ", k, ": height over theory's ", mean, ", echo ", 100.0 * echo,
                " %, mean level ", 1000.0 * (level - 1.0), " mm, water taken ", s.accounts.outflow.mass,
                " kg");
        CHECK(mean == doctest::Approx(1.0).epsilon(0.1));
        CHECK(echo < 0.15);
    }
}
