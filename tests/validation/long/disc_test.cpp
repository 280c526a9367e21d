// The discs of disc_test.cpp through 1e5 steps.
//
// A disc starts without stress. Spun, it grows; with its angular momentum it then has less energy by the
// share of its growth, (rim speed/c)² / 4 or so, which rings away in its breathing. Nothing else is lost.
#include <doctest/doctest.h>

#include "support/spinning.h"

using namespace tidewater;

TEST_CASE("a spinning disc loses the energy of its ringing in 1e5 steps and no more") {
    for (const double rim_speed : {0.01, 0.03, 0.1}) {
        const auto result = test::run_spin<2, double>({10, rim_speed, 0.0, 100000});
        test::check_spin(result, 1e-10);
        CHECK(result.lost < 1.2 * result.growth);
    }
}

TEST_CASE("a flying disc that spins keeps its momenta through 1e5 steps") {
    test::check_spin(test::run_spin<2, double>({10, 0.03, 0.01, 100000}), 1e-10);
    test::check_spin(test::run_spin<2, float>({10, 0.03, 0.01, 100000}), 2e-5);
}
