#include "mpm/materials/water.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace tidewater::mpm;

namespace {

double energy_at(double j, double bulk_modulus, int exponent) {
    Column<double> column{}, energy;
    column[0] = j;
    water_energy(column, bulk_modulus, exponent, energy);
    return energy[0];
}

double energy_at(double j, const WaterModel& water) {
    Column<double> column{}, energy;
    column[0] = j;
    water_energy(column, water, energy);
    return energy[0];
}

}  // namespace

TEST_CASE("the default water has the paper's bulk modulus of 10 MPa") {
    CHECK(WaterModel{}.bulk_modulus() == doctest::Approx(1e7).epsilon(1e-12));
}

TEST_CASE("water pressure is eq. 7 for any whole exponent, in float down to strains of 1e-6") {
    for (const int theta : {2, 3, 7, 9}) {
        for (const double j : {-0.3, -0.01, -1e-3, -1e-6, 0.0, 1e-6, 1e-3, 0.2, 3.0}) {
            const double exact = 1e7 * std::expm1(-theta * std::log1p(j));
            CAPTURE(theta);
            CAPTURE(j);
            CHECK(water_pressure(j, 1e7, theta) == doctest::Approx(exact).epsilon(1e-13));
            CHECK(water_pressure(static_cast<float>(j), 1e7f, theta) == doctest::Approx(exact).epsilon(2e-6));
        }
    }
}

TEST_CASE("pressure is minus the slope of the stored energy") {
    const double h = 1e-5;
    for (const double j : {-0.2, -0.01, 0.0, 0.05}) {
        const double slope = (energy_at(j + h, 1e7, 7) - energy_at(j - h, 1e7, 7)) / (2 * h);
        CHECK(-slope == doctest::Approx(water_pressure(j, 1e7, 7)).epsilon(1e-6).scale(1e5));
    }
    CHECK(energy_at(0.0, 1e7, 7) == 0.0);
}

TEST_CASE("the stored energy keeps its digits down to strains of 1e-9, for any whole exponent") {
    for (const int theta : {2, 3, 7, 9}) {
        for (const double j : {-0.3, -1e-2, 0.5}) {
            const double exact = 1e7 * ((std::pow(1 + j, 1 - theta) - 1) / (theta - 1) + j);
            CHECK(energy_at(j, 1e7, theta) == doctest::Approx(exact).epsilon(1e-11));
        }
        CHECK(energy_at(-1e-9, 1e7, theta) / (0.5e7 * theta * 1e-18) == doctest::Approx(1.0).epsilon(1e-7));
    }
}

TEST_CASE("the sound speed is √(dp/dρ)") {
    const WaterModel water;
    const double h = 1e-6;
    for (const double j : {-0.05, -0.001, 0.0}) {
        // ρ = ρw/J, so dp/dρ = −(J²/ρw) dp/dJ.
        const double slope = (water_pressure(j + h, water.bulk_modulus(), 7) -
                              water_pressure(j - h, water.bulk_modulus(), 7)) /
                             (2 * h);
        const double c = std::sqrt(-(1 + j) * (1 + j) / water.density * slope);
        CHECK(water.sound_speed * water_sound_speed_ratio(j, 7) == doctest::Approx(c).epsilon(1e-6));
    }
}

TEST_CASE("hydrostatic water balances J p = ρ g h, and is undeformed above the surface") {
    for (const double c0 : {0.5, 15.0, 31.0, 264.6}) {
        WaterModel water;
        water.sound_speed = c0;
        for (const double h : {1e-6, 0.1, 1.0, 5.0}) {
            const double j = hydrostatic_j(h, 9.81, water);
            CHECK((1 + j) * water_pressure(j, water.bulk_modulus(), 7) ==
                  doctest::Approx(9810.0 * h).epsilon(1e-9));
        }
        CHECK(hydrostatic_j(0.0, 9.81, water) == 0.0);
        CHECK(hydrostatic_j(-1.0, 9.81, water) == 0.0);
    }
}

TEST_CASE("stretched water pulls in the paper's way and opens in ours, with the energy that belongs to it") {
    WaterModel water;
    CHECK(water_pressure(0.01, water) == 0.0);
    CHECK(energy_at(0.01, water) == 0.0);
    CHECK(water_pressure(-0.01, water) == water_pressure(-0.01, water.bulk_modulus(), water.exponent));
    CHECK(energy_at(-0.01, water) == energy_at(-0.01, water.bulk_modulus(), water.exponent));
    water.tension = WaterTension::paper;
    CHECK(water_pressure(0.01, water) == water_pressure(0.01, water.bulk_modulus(), water.exponent));
    CHECK(energy_at(0.01, water) > 0.0);
}

TEST_CASE("a column under its own weight: mass, depth and pressure agree") {
    for (const double c : {10.0, 31.0, 264.6}) {
        WaterModel water;
        water.sound_speed = c;
        double mass = 0.0;
        const int steps = 100000;
        for (int k = 0; k < steps; ++k) {  // ∫ dh/J
            const double h = 2.0 * (k + 0.5) / steps;
            mass += 2.0 / steps / (1.0 + j_under_weight(weighed_depth(h, 9.81, water), 9.81, water));
        }
        CHECK(weighed_depth(2.0, 9.81, water) == doctest::Approx(mass).epsilon(1e-8));
        CHECK(depth_of_weight(mass, 9.81, water) == doctest::Approx(2.0).epsilon(1e-8));
        CHECK(water_pressure(j_under_weight(mass, 9.81, water), water) ==
              doctest::Approx(9810.0 * mass).epsilon(1e-10));
    }
    CHECK(weighed_depth(3.0, 0.0, WaterModel{}) == 3.0);
    CHECK(j_under_weight(-1.0, 9.81, WaterModel{}) == 0.0);
}
