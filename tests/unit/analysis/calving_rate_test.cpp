#include "analysis/calving_rate.h"

#include <doctest/doctest.h>

using namespace tidewater::analysis;

TEST_CASE("what calves evenly has one rate, whatever the window and the times") {
    const std::vector<double> time{0.0, 1.0, 3.0, 4.0, 8.0}, calved{0.0, 5.0, 10.0, 5.0, 20.0};
    for (const double window : {0.1, 2.0, 5.0, 100.0}) {
        for (const double rate : calving_rate(time, calved, window)) CHECK(rate == doctest::Approx(5.0));
    }
}

TEST_CASE("one event is spread over the window and keeps its volume") {
    std::vector<double> time, calved;
    for (int i = 0; i <= 100; ++i) {
        time.push_back(0.5 * i);
        calved.push_back(i == 50 ? 300.0 : 0.0);
    }
    const auto rate = calving_rate(time, calved, 10.0);
    CHECK(rate[50] == doctest::Approx(30.0));
    CHECK(rate[20] == 0.0);
    double volume = 0.0;
    for (const double r : rate) volume += 0.5 * r;
    CHECK(volume == doctest::Approx(300.0));
}

TEST_CASE("no time and one time have no rate") {
    CHECK(calving_rate({}, {}, 1.0).empty());
    CHECK(calving_rate(std::vector{3.0}, std::vector{0.0}, 1.0) == std::vector{0.0});
}
