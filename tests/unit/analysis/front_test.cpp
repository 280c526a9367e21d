#include "analysis/front.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace tidewater::analysis;

TEST_CASE("the front is where water ends, not ice, nor drops ahead") {
    const std::vector<float> points{2.0f, 0, 0, 0.5f, 0, 0, 1.0f, 0, 0, 1.4f, 0, 1, 3.0f, 0, 0};
    const std::vector<std::uint8_t> water{0, 0, 0, 0, 0}, mixed{1, 0, 0, 0, 0};
    CHECK(water_front(points, water, 0.7) == 2.0);
    CHECK(water_front(points, water, 1.1) == 3.0);
    CHECK(water_front(points, mixed, 0.7) == doctest::Approx(1.4));
    CHECK(water_front(points, water, 0.1) == 0.5);
    CHECK(std::isnan(water_front({}, {}, 1.0)));
}
