// Discs and balls of elastic ice in free flight: momenta stay, energy never grows, what spins stays round.
#include <doctest/doctest.h>

#include "support/spinning.h"

using namespace tidewater;
using test::Spin;
using test::SpinResult;

namespace {

// tolerance: of momenta and of an energy that grows; both relative
void check(const SpinResult& result, double tolerance) {
    MESSAGE("momentum " << result.linear << ", angular momentum " << result.angular << ", highest energy "
                        << result.highest << ", energy lost " << result.lost << " in " << result.turns
                        << " turns");
    CHECK(result.finite);
    CHECK(result.linear < tolerance);
    CHECK(result.angular < tolerance);
    CHECK(result.highest < tolerance);
    CHECK(result.lost < 0.01);
    CHECK(result.oblate < 0.005);
    CHECK(result.growth < 0.01);
}

}  // namespace

TEST_CASE("a spinning disc keeps its momenta, its shape and its energy") {
    for (const double rim_speed : {0.01, 0.1})
        check(test::run_spin<2, double>({10, rim_speed, 0.0, 2000}), 1e-10);
    check(test::run_spin<2, float>({10, 0.1, 0.0, 2000}), 1e-5);
}

TEST_CASE("a flying disc that spins keeps its momenta, its shape and its energy") {
    check(test::run_spin<2, double>({10, 0.03, 0.03, 2000}), 1e-10);
    check(test::run_spin<2, float>({10, 0.03, 0.03, 2000}), 1e-5);
}

TEST_CASE("a disc that flies without spin loses nothing") {
    const auto result = test::run_spin<2, double>({10, 0.0, 0.03, 1000});
    check(result, 1e-10);
    CHECK(result.lost < 1e-12);
}

TEST_CASE("a flying ball that spins keeps its momenta, its shape and its energy") {
    check(test::run_spin<3, double>({5, 0.03, 0.03, 500}), 1e-10);
    check(test::run_spin<3, float>({5, 0.03, 0.03, 500}), 1e-5);
}
