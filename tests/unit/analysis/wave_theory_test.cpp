#include "analysis/wave_theory.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

using namespace tidewater::analysis;

namespace {

constexpr double pi = std::numbers::pi;

InitialWave solitary(double relative, double depth = 1.0) {
    return {.kind = WaveKind::solitary, .height = relative * depth, .center = 8.0 * depth, .depth = depth};
}

InitialWave standing(double height = 0.05) { return {.height = height, .length = 4.0, .depth = 1.0}; }

// What is open on the surface: the kinematic condition (u − c) ∂η/∂x = w over √(gD), and p/ρgD.
struct Residual {
    double kinematic = 0.0, pressure = 0.0;
};

Residual surface_residual(const InitialWave& wave) {
    Residual worst;
    const double c = solitary_celerity(wave), long_wave = std::sqrt(wave.gravity * wave.depth);
    for (double x = wave.center - 8.0 * wave.depth; x < wave.center + 8.0 * wave.depth;
         x += 0.05 * wave.depth) {
        const WaveFlow flow = wave_flow(wave, x, wave.depth + elevation(wave, x));
        const double kinematic = (flow.u - c) * elevation_slope(wave, x) - flow.w;
        worst.kinematic = std::max(worst.kinematic, std::abs(kinematic) / long_wave);
        worst.pressure = std::max(worst.pressure, std::abs(flow.head) / wave.depth);
    }
    return worst;
}

}  // namespace

TEST_CASE("the dispersion relation has the long and the short wave's limit") {
    CHECK(angular_frequency(1e-3, 2.0, 9.81) == doctest::Approx(1e-3 * std::sqrt(9.81 * 2.0)).epsilon(1e-5));
    CHECK(angular_frequency(10.0, 2.0, 9.81) == doctest::Approx(std::sqrt(9.81 * 10.0)).epsilon(1e-9));
    CHECK(2.0 * pi / angular_frequency(2.0 * pi / 4.0, 1.0, 9.81) == doctest::Approx(1.671).epsilon(3e-4));
    CHECK(2.0 * pi / angular_frequency(2.0 * pi / 32.0, 1.0, 9.81) == doctest::Approx(10.28).epsilon(3e-4));
}

TEST_CASE("a solitary wave's free surface is open by the fourth order of its height") {
    const Residual low = surface_residual(solitary(0.05)), high = surface_residual(solitary(0.1));
    CHECK(high.kinematic / low.kinematic > 14.0);
    CHECK(high.pressure / low.pressure > 14.0);
    const Residual usual = surface_residual(solitary(0.2, 3.0));
    CHECK(usual.kinematic < 2e-3);
    CHECK(usual.pressure < 2.1e-3);
    CHECK(surface_residual(solitary(highest_solitary)).kinematic < 0.08);
}

TEST_CASE("a low solitary wave is Boussinesq's") {
    const InitialWave wave = solitary(0.01);
    const double c = std::sqrt(wave.gravity * (wave.depth + wave.height));
    CHECK(solitary_celerity(wave) == doctest::Approx(c).epsilon(1e-5));
    for (const double from : {0.0, 2.0, 5.0, 9.0}) {
        const double s = 1.0 / std::cosh(std::sqrt(0.75 * wave.height) * from);
        CHECK(elevation(wave, wave.center + from) ==
              doctest::Approx(wave.height * s * s).scale(1e-2).epsilon(0.01));
        CHECK(wave_flow(wave, wave.center + from, 0.3).u ==
              doctest::Approx(c * wave.height * s * s).scale(0.03).epsilon(0.02));
    }
}

TEST_CASE("a solitary wave is as high as asked for at its crest, and no water passes the bed") {
    for (const double relative : {0.05, 0.2, 0.4}) {
        const InitialWave wave = solitary(relative, 2.0);
        CHECK(elevation(wave, wave.center) == doctest::Approx(wave.height));
        CHECK(elevation(wave, wave.center + 1.0) < wave.height);
        CHECK(wave_flow(wave, wave.center + 1.3, 0.0).w == 0.0);
        CHECK(wave_flow(wave, wave.center + 1.3, 1.0).w > 0.0);  // rises ahead of the crest
    }
}

TEST_CASE("a solitary wave's flow has its gradient, no divergence and no rotation") {
    const InitialWave wave = solitary(0.3);
    constexpr double h = 1e-5;
    for (const double x : {6.5, 7.9, 8.6}) {
        for (const double z : {0.0, 0.4, 1.1}) {
            const WaveFlow flow = wave_flow(wave, x, z);
            const WaveFlow left = wave_flow(wave, x - h, z), right = wave_flow(wave, x + h, z);
            const WaveFlow below = wave_flow(wave, x, z - h), above = wave_flow(wave, x, z + h);
            CHECK((right.u - left.u) / (2.0 * h) == doctest::Approx(flow.u_x).epsilon(1e-6));
            CHECK((above.u - below.u) / (2.0 * h) == doctest::Approx(flow.u_z).epsilon(1e-6));
            CHECK((above.w - below.w) / (2.0 * h) == doctest::Approx(-flow.u_x).epsilon(1e-6));
            CHECK((right.w - left.w) / (2.0 * h) == doctest::Approx(flow.u_z).epsilon(1e-6));
        }
    }
}

TEST_CASE("slope and area belong to the elevation") {
    constexpr double h = 1e-5;
    for (const InitialWave& wave : {standing(), solitary(0.3)}) {
        CHECK(elevated_area(wave, 0.0) == 0.0);
        for (const double x : {0.3, 1.2, 6.5, 8.0, 8.4}) {
            const double slope = (elevation(wave, x + h) - elevation(wave, x - h)) / (2.0 * h);
            CHECK(elevation_slope(wave, x) == doctest::Approx(slope).scale(0.1).epsilon(1e-8));
            const double eta = (elevated_area(wave, x + h) - elevated_area(wave, x - h)) / (2.0 * h);
            CHECK(elevation(wave, x) == doctest::Approx(eta).scale(0.1).epsilon(1e-8));
        }
    }
}

TEST_CASE("a standing wave starts at rest with the pressure of linear theory, none of it on the surface") {
    const InitialWave wave = standing();
    const double k = 2.0 * pi / wave.length;
    for (const double x : {0.0, 0.7, 1.0, 2.0}) {
        const double eta = elevation(wave, x);
        CHECK(eta == doctest::Approx(0.05 * std::cos(k * x)));
        CHECK(std::abs(wave_flow(wave, x, 1.0 + eta).head) < 1e-15);
        const WaveFlow bed = wave_flow(wave, x, 0.0);
        CHECK(bed.head == doctest::Approx(1.0 + eta / std::cosh(k)));
        CHECK(bed.u == 0.0);
        CHECK(bed.w == 0.0);
    }
}

TEST_CASE("displaced water keeps every share of it, and its surface is the wave's") {
    constexpr double h = 1e-5;
    for (const InitialWave& wave : {standing(0.2), solitary(0.4)}) {
        for (const double x : {0.01, 1.1, 7.7, 8.9, 15.0}) {
            for (const double z : {0.1, 0.9}) {
                const Displaced at = displace(wave, x, z);
                const Displaced right = displace(wave, x + h, z), left = displace(wave, x - h, z);
                const Displaced above = displace(wave, x, z + h), below = displace(wave, x, z - h);
                const double area =
                    ((right.x - left.x) * (above.z - below.z) - (above.x - below.x) * (right.z - left.z)) /
                    (4.0 * h * h);
                CHECK(area == doctest::Approx(1.0).epsilon(1e-7));
                CHECK(at.z == doctest::Approx(z * (1.0 + elevation(wave, at.x))));
            }
            const Displaced top = displace(wave, x, 1.0);
            CHECK(top.z == doctest::Approx(1.0 + elevation(wave, top.x)));
            CHECK(top.x + elevated_area(wave, top.x) == doctest::Approx(x));
        }
    }
    CHECK(displace(standing(), 2.0, 0.5).x == doctest::Approx(2.0));  // at a wall
}
