// Discs and balls of elastic ice in free flight: momenta stay, energy never grows, what spins stays round.
#include <doctest/doctest.h>

#include "support/spinning.h"

using namespace tidewater;

TEST_CASE("a spinning disc keeps its momenta, its shape and its energy") {
    for (const double rim_speed : {0.01, 0.1})
        test::check_spin(test::run_spin<2, double>({10, rim_speed, 0.0, 2000}), 1e-10);
    test::check_spin(test::run_spin<2, float>({10, 0.1, 0.0, 2000}), 1e-5);
}

TEST_CASE("a flying disc that spins keeps its momenta, its shape and its energy") {
    test::check_spin(test::run_spin<2, double>({10, 0.03, 0.03, 2000}), 1e-10);
    test::check_spin(test::run_spin<2, float>({10, 0.03, 0.03, 2000}), 1e-5);
}

TEST_CASE("a disc that flies without spin loses nothing") {
    const auto result = test::run_spin<2, double>({10, 0.0, 0.03, 1000});
    test::check_spin(result, 1e-10);
    CHECK(result.lost < 1e-12);
}

TEST_CASE("a flying ball that spins keeps its momenta, its shape and its energy") {
    test::check_spin(test::run_spin<3, double>({5, 0.03, 0.03, 500}), 1e-10);
    test::check_spin(test::run_spin<3, float>({5, 0.03, 0.03, 500}), 1e-5);
}
