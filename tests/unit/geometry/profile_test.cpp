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

namespace {

// Level before x = 2 m, a rise to 6 m, a steep fall to 7 m.
const Profile ramps{{2.0, 6.0, 7.0}, {1.0, 4.0, 0.0}, true};

// From 10⁵ places along the surface: at least the true distance, by at most 1e-8 m here.
double searched_distance(const Profile& profile, const Point& point) {
    double least = 1e300, at = 0.0;
    for (int level = 0; level < 4; ++level) {
        const double half = level == 0 ? 12.0 : 24.0 * std::pow(1e-4, level), from = at - half;
        for (int n = 0; n <= 40000; ++n) {
            const double x = from + 2.0 * half * n / 40000;
            const double distance = std::hypot(x - point[0], profile.height(x) - point[2]);
            if (distance < least) least = distance, at = x;
        }
    }
    return least;
}

}  // namespace

TEST_CASE("a smooth profile goes through its points, level there, without a jump of the slope") {
    const double h = 1e-6;
    for (std::size_t i = 0; i < ramps.x.size(); ++i) {
        const double x = ramps.x[i];
        CHECK(ramps.height(x) == doctest::Approx(ramps.z[i]));
        CHECK(std::abs(ramps.height(x + h) - ramps.height(x - h)) < 1e-4 * h);
    }
    CHECK(ramps.height(4.0) == doctest::Approx(2.5));  // half the way, half the rise
    CHECK(ramps.height(3.0) == doctest::Approx(1.0 + 3.0 * (3.0 - 0.5) / 16.0));  // s(¼) = 5/32
    CHECK((ramps.height(4.0 + h) - ramps.height(4.0 - h)) / (2.0 * h) == doctest::Approx(1.5 * 0.75));
    CHECK(ramps.height(-9.0) == 1.0);
    CHECK(ramps.height(9.0) == 0.0);
    CHECK(ramps.highest(3.0, 6.5) == 4.0);
    CHECK(ramps.highest(6.5, 9.0) == doctest::Approx(2.0));
}

TEST_CASE("the distance to a smooth profile is the true one, never above it") {
    for (double x = -1.0; x < 9.0; x += 0.37) {
        for (double z = -2.0; z < 7.0; z += 0.41) {
            const Point point(x, 5.0, z);
            const double truth = searched_distance(ramps, point), found = signed_distance(ramps, point);
            CAPTURE(x);
            CAPTURE(z);
            CHECK(std::abs(found) <= truth + 1e-12);
            CHECK(std::abs(found) == doctest::Approx(truth).epsilon(1e-7).scale(1.0));
            CHECK((found < 0.0) == (z < ramps.height(x)));
        }
    }
    const Profile level{{0.0, 1.0}, {2.0, 2.0}, true};
    CHECK(signed_distance(level, Point(0.5, 0.0, 5.0)) == doctest::Approx(3.0));
    CHECK(signed_distance(Profile{{0.0}, {2.0}, true}, Point(0.5, 0.0, 1.0)) == doctest::Approx(-1.0));
}

TEST_CASE("the area below a smooth profile is the integral of its height") {
    for (const double length : {1.0, 3.3, 5.0, 6.5, 10.0}) {
        for (const double top : {0.5, 1.0, 2.0, 3.9, 8.0}) {
            double sum = 0.0;
            const int count = 200000;
            for (int n = 0; n < count; ++n)
                sum += std::clamp(ramps.height((n + 0.5) * length / count), 0.0, top) * length / count;
            CHECK(area_below(ramps, length, top) == doctest::Approx(sum).epsilon(1e-6));
        }
    }
    // The mean of a ramp is that of its ends.
    CHECK(area_below(Profile{{0.0, 8.0}, {1.0, 3.0}, true}, 8.0, 9.0) == doctest::Approx(16.0));
    // Ground below the tank's floor does not count.
    const Profile dips{{0.0, 2.0}, {-1.0, 1.0}, true};
    CHECK(area_below(dips, 2.0, 9.0) == doctest::Approx(0.625));  // 2 ∫ 2s − 1 from ½ to 1
}

TEST_CASE("a smooth profile rises into a box where the two differ most") {
    for (const double angle : {0.0, 0.3, 0.7853981633974483, 1.2, -0.5}) {
        for (double x = 1.0; x < 8.0; x += 0.45) {
            const Box box{{x, 0.0, 3.0}, {0.8, 1.0, 0.4}, angle};
            double most = -1e300;
            for (const auto& from : corners(box)) {
                for (const auto& to :
                     corners(box)) {  // the sides and the diagonals: the lowest are the sides
                    for (int n = 0; n <= 2000; ++n) {
                        const Vector<2, double> at = from + (to - from) * (n / 2000.0);
                        most = std::max(most, ramps.height(at[0]) - at[1]);
                    }
                }
            }
            CAPTURE(angle);
            CAPTURE(x);
            CHECK(rise_into(ramps, box) >= most - 1e-12);
            CHECK(rise_into(ramps, box) == doctest::Approx(most).epsilon(1e-5).scale(1.0));
        }
    }
}
