#include "analysis/dispersion.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "analysis/wave_theory.h"

using namespace tidewater::analysis;

TEST_CASE("the wavenumber is the inverse of the dispersion relation from the shallowest to the deepest") {
    for (const double kd : {1e-6, 1e-3, 0.1, 0.5, 1.0, 1.2, 2.0, 5.0, 30.0, 1e4}) {
        const double depth = 7.0, k = kd / depth, frequency = angular_frequency(k, depth, 9.81);
        CHECK(dispersion_wavenumber(frequency, depth, 9.81) == doctest::Approx(k).epsilon(1e-10));
    }
}

TEST_CASE("the group celerity is the slope of the dispersion relation") {
    for (const double kd : {0.01, 0.3, 1.0, 3.0, 10.0}) {
        const double k = kd / 2.0, h = 1e-5 * k;
        const double slope =
            (angular_frequency(k + h, 2.0, 9.81) - angular_frequency(k - h, 2.0, 9.81)) / (2.0 * h);
        CHECK(group_celerity(angular_frequency(k, 2.0, 9.81), 2.0, 9.81) ==
              doctest::Approx(slope).epsilon(1e-6));
    }
}

TEST_CASE("long waves carry energy at √(gD), waves in deep water at g/2ω") {
    CHECK(group_celerity(0.0, 4.0, 9.81) == doctest::Approx(std::sqrt(4.0 * 9.81)));
    CHECK(group_celerity(1e-4, 4.0, 9.81) == doctest::Approx(std::sqrt(4.0 * 9.81)));
    CHECK(group_celerity(3000.0, 4.0, 9.81) == doctest::Approx(9.81 / 6000.0));
}
