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

TEST_CASE("boxes are as far apart as the axis that separates them best tells") {
    const Box box{{0, 0, 0}, {0.5, 1, 0.25}, 0.0};
    CHECK(separation(box, {{2, 0, 0}, {0.5, 1, 0.25}, 0.0}) == doctest::Approx(1.0));
    CHECK(separation(box, {{1, 0, 0}, {0.5, 1, 0.25}, 0.0}) == doctest::Approx(0.0));
    CHECK(separation(box, {{0.9, 0, 0.1}, {0.5, 1, 0.25}, 0.0}) == doctest::Approx(-0.1));
    CHECK(separation(box, {{0, 3, 0}, {0.5, 1, 0.25}, 0.3}) == doctest::Approx(1.0));
    // A square on its corner beside an upright one: their upright bounds overlap, they do not.
    const double quarter = std::numbers::pi / 4;
    const Box square{{0, 0, 0}, {0.5, 1, 0.5}, 0.0};
    CHECK(separation(square, {{0.95, 0, 0.95}, {0.5, 1, 0.5}, quarter}) ==
          doctest::Approx(0.95 * std::sqrt(2.0) - 0.5 - std::sqrt(0.5)));
    CHECK(separation(square, {{1.2, 0, 0}, {0.5, 1, 0.5}, quarter}) ==
          doctest::Approx(1.2 - 0.5 - std::sqrt(0.5)));
    CHECK(separation({{1.2, 0, 0}, {0.5, 1, 0.5}, quarter}, square) ==
          separation(square, {{1.2, 0, 0}, {0.5, 1, 0.5}, quarter}));
}

TEST_CASE("a box floats with its share of the area below the level, whatever its angle") {
    const Box upright{{3, 0, 7}, {0.125, 1, 0.4}, 0.0};
    CHECK(floating_height(upright, 1.0, 0.92) == doctest::Approx(1.0 - 0.92 * 0.8 + 0.4));
    const Box square{{0, 0, 0}, {0.5, 1, 0.5}, std::numbers::pi / 4};
    CHECK(floating_height(square, 2.0, 0.5) == doctest::Approx(2.0));
    // A corner triangle of area 0.08 stands out: its height is √0.08, below the corner at √½.
    CHECK(floating_height(square, 0.0, 0.92) == doctest::Approx(std::sqrt(0.08) - std::sqrt(0.5)));
    for (const double degrees : {-70.0, -12.0, 35.0, 90.0, 144.0}) {
        Box box{{0, 0, 0}, {0.125, 1, 0.4}, degrees * std::numbers::pi / 180.0};
        for (const double share : {0.05, 0.5, 0.92}) {
            box.center[2] = floating_height(box, 1.0, share);
            CHECK(area_below(box, 1.0) == doctest::Approx(share * 0.2).epsilon(1e-9));
        }
        box.center[2] = floating_height(box, 1.0, 1.0);
        CHECK(box.center[2] + reach(box)[2] == doctest::Approx(1.0));
        box.center[2] = floating_height(box, 1.0, 0.0);
        CHECK(box.center[2] - reach(box)[2] == doctest::Approx(1.0));
    }
}
