#include "geometry/box.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <cmath>
#include <numbers>

using namespace tidewater::geometry;

TEST_CASE("the distance to an upright box is exact at faces, edges and corners") {
    const Box box{{1, 2, 3}, {0.5, 1.0, 2.0}, 0.0};
    CHECK(signed_distance(box, {1, 2, 3}) == doctest::Approx(-0.5));
    CHECK(signed_distance(box, {1.5, 2, 3}) == doctest::Approx(0.0));
    CHECK(signed_distance(box, {2.5, 2, 3}) == doctest::Approx(1.0));
    CHECK(signed_distance(box, {1.5 + 3, 3 + 4, 3}) == doctest::Approx(5.0));
    CHECK(signed_distance(box, {1.5 + 1, 3 + 2, 5 + 2}) == doctest::Approx(3.0));
}

TEST_CASE("a turned box is an upright one seen from a turned frame") {
    const double angle = 35.0 * std::numbers::pi / 180.0;
    const Box upright{{0, 0, 0}, {0.4, 1.0, 0.125}, 0.0};
    Box turned = upright;
    turned.angle = angle;
    for (const Point& p : {Point(0.3, 0.1, 0.2), Point(-1, 0, 0.4), Point(0.39, 0, 0)}) {
        const Point there(std::cos(angle) * p[0] - std::sin(angle) * p[2], p[1],
                          std::sin(angle) * p[0] + std::cos(angle) * p[2]);
        CHECK(signed_distance(turned, there) == doctest::Approx(signed_distance(upright, p)).epsilon(1e-12));
    }
}

TEST_CASE("the shared area is exact for boxes inside, outside, halfway and turned") {
    const Box water{{8, 0, 0.5}, {8, 1, 0.5}, 0.0};
    CHECK(shared_area({{4, 0, 0.5}, {0.25, 1, 0.25}, 0.0}, water) == doctest::Approx(0.25));
    CHECK(shared_area({{4, 0, 0.5}, {0.25, 1, 0.25}, 0.7}, water) == doctest::Approx(0.25));
    CHECK(shared_area({{4, 0, 1.25}, {0.25, 1, 0.25}, 0.0}, water) == doctest::Approx(0.0));
    CHECK(shared_area({{4, 0, 1.0}, {0.25, 1, 0.25}, 0.0}, water) == doctest::Approx(0.125));
    CHECK(shared_area({{4, 0, 1.0}, {0.4, 1, 0.125}, 0.6}, water) ==
          doctest::Approx(0.1));  // half, by symmetry
    // A square on its corner, its upper half-diagonal 0.1 below the top: the rest is the whole square.
    const double diagonal = std::sqrt(2.0) * 0.25;
    const Box square{{4, 0, 1.0 - diagonal + 0.1}, {0.25, 1, 0.25}, std::numbers::pi / 4};
    CHECK(shared_area(square, water) == doctest::Approx(0.25 - 0.01));  // a triangle of height 0.1 stands out
}
