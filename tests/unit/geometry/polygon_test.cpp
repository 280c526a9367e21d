#include "geometry/polygon.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace tidewater::geometry;
using Corner = tidewater::Vector<2, double>;

namespace {

// A glacier's section with an overhanging nose; area 100·100 + triangle.
const Polygon nose{{0, 0}, {0, 100}, {100, 100}, {120, 60}, {100, 0}};

}  // namespace

TEST_CASE("an outline's area, and what lies below a height, are exact whichever way it runs") {
    const Polygon reversed(nose.rbegin(), nose.rend());
    CHECK(area(nose) == doctest::Approx(11000.0).epsilon(1e-14));
    CHECK(area(reversed) == doctest::Approx(11000.0).epsilon(1e-14));
    CHECK(area_below(nose, 60.0) == doctest::Approx(6600.0).epsilon(1e-14));
    CHECK(area_below(nose, 30.0) == doctest::Approx(3150.0).epsilon(1e-14));
    CHECK(area_below(nose, -1.0) == 0.0);
    // A notched outline is left in two parts, which the cut joins by an edge without area.
    const Polygon notched{{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 0}};
    CHECK(area(clipped(notched, 1, -1.0, -1.5)) == doctest::Approx(1.0).epsilon(1e-14));
}

TEST_CASE("the distance to an outline is that to its nearest edge, negative inside") {
    CHECK(signed_distance(nose, {50, 90}) == doctest::Approx(-10.0));
    CHECK(signed_distance(nose, {-3, -4}) == doctest::Approx(5.0));
    CHECK(signed_distance(nose, {130, 60}) == doctest::Approx(10.0));
    CHECK(signed_distance(nose, {110, 60}) == doctest::Approx(-10.0 * std::cos(std::atan2(20.0, 40.0))));
    CHECK(signed_distance(nose, {100, 50}) < 0.0);
}

TEST_CASE("an outline tells its top, its front and where it crosses itself") {
    CHECK(*top_at(nose, 50.0) == 100.0);
    CHECK(*top_at(nose, 110.0) == doctest::Approx(80.0));
    CHECK_FALSE(top_at(nose, 121.0));
    CHECK(*front_at(nose, 60.0) == 120.0);
    CHECK(*front_at(nose, 30.0) == doctest::Approx(110.0));
    CHECK_FALSE(crossing(nose));
    const auto bow = crossing({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    REQUIRE(bow);
    CHECK((*bow - Corner(1, 1)).norm() < 1e-14);
}

TEST_CASE("an outline floats with the share of its area below the level that its density asks for") {
    for (const double share : {0.1, 0.5, 0.9}) {
        const double rise = rise_to_float(nose, 70.0, share);
        CHECK(area_below(nose, 70.0 - rise) == doctest::Approx(share * 11000.0).epsilon(1e-12));
    }
}
