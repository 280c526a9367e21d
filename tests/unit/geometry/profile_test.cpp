#include "geometry/profile.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

const Profile slope{{2.0, 6.0, 7.0}, {1.0, 4.0, 0.0}};

}  // namespace

TEST_CASE("a profile is straight between its points and level beyond them") {
    CHECK(slope.height(-5.0) == 1.0);
    CHECK(slope.height(2.0) == 1.0);
    CHECK(slope.height(4.0) == doctest::Approx(2.5));
    CHECK(slope.height(6.0) == 4.0);
    CHECK(slope.height(6.25) == doctest::Approx(3.0));
    CHECK(slope.height(7.0) == 0.0);
    CHECK(slope.height(100.0) == 0.0);
    CHECK(Profile{{3.0}, {2.0}}.height(1.0) == 2.0);
}

TEST_CASE("the distance to a profile is that to its nearest line, negative in the ground, whatever y is") {
    CHECK(signed_distance(slope, Point(0.0, 9.0, 3.0)) == doctest::Approx(2.0));
    CHECK(signed_distance(slope, Point(0.0, 0.0, 0.5)) == doctest::Approx(-0.5));
    CHECK(signed_distance(slope, Point(4.0, 0.0, 3.75)) == doctest::Approx(1.0));  // 1.25 · cos of 3 : 4
    CHECK(signed_distance(slope, Point(4.0, 0.0, 1.25)) == doctest::Approx(-1.0));
    CHECK(signed_distance(slope, Point(6.0, 0.0, 6.0)) == doctest::Approx(2.0));  // above the peak
    CHECK(signed_distance(slope, Point(9.0, 0.0, 0.5)) == doctest::Approx(0.5));
    CHECK(signed_distance(Profile{{3.0}, {2.0}}, Point(8.0, 0.0, 1.0)) == doctest::Approx(-1.0));
}

TEST_CASE("the area of the ground below a level is the integral of its height") {
    for (const double length : {1.0, 5.0, 6.5, 10.0}) {
        for (const double top : {0.5, 1.0, 2.0, 3.9, 8.0}) {
            double sum = 0.0;
            const int count = 200000;
            for (int n = 0; n < count; ++n) {
                const double z = slope.height((n + 0.5) * length / count);
                sum += std::clamp(z, 0.0, top) * length / count;
            }
            CHECK(area_below(slope, length, top) == doctest::Approx(sum).epsilon(1e-6));
        }
    }
}

TEST_CASE("the ground rises into a box by what it is above the box's lower side") {
    const auto box = [](double x, double z, double half, double angle) {
        return Box{{x, 0.0, z}, {half, 1.0, half}, angle};
    };
    CHECK(rise_into(slope, box(0.0, 2.0, 0.5, 0.0)) == doctest::Approx(-0.5));
    CHECK(rise_into(slope, box(0.0, 1.5, 0.5, 0.0)) == doctest::Approx(0.0));
    CHECK(rise_into(slope, box(3.0, 2.5, 0.5, 0.0)) ==
          doctest::Approx(1.0 + 0.75 * 1.5 - 2.0));                              // its corner
    CHECK(rise_into(slope, box(6.0, 4.25, 0.5, 0.0)) == doctest::Approx(0.25));  // the peak
    const Profile spike{{0.9, 1.0, 1.1}, {0.0, 9.0, 0.0}};                       // through the whole box
    CHECK(rise_into(spike, box(1.0, 4.0, 0.5, 0.0)) == doctest::Approx(5.5));
    const double quarter = 0.7853981633974483;  // on its corner, which the level ground beyond the ends meets
    CHECK(rise_into(slope, box(9.0, 0.5, 0.5, quarter)) == doctest::Approx(std::sqrt(0.5) - 0.5));
}
