#include "geometry/height_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

HeightField sampled(int nx, int ny, double spacing, double x0, double y0,
                    const std::function<double(double, double)>& z) {
    HeightField field{spacing, nx, ny, {}, x0, y0};
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < ny; ++j) field.heights.push_back(z(x0 + i * spacing, y0 + j * spacing));
    }
    return field;
}

// Hills with a cliff: slopes from 0 to about 3.
HeightField hills() {
    return sampled(9, 7, 2.0, 1.0, -3.0, [](double x, double y) {
        return 3.0 * std::sin(0.4 * x) + std::cos(0.7 * y) + (x > 8.0 ? 5.0 : 0.0) + 0.01 * x * y;
    });
}

// From places along the surface, finer and finer around the nearest: at least the true distance.
double searched_distance(const HeightField& field, const Point& point) {
    double least = 1e300, best_x = point[0], best_y = point[1];
    for (double half = 16.0; half > 1e-4; half *= 0.25) {
        const double x = best_x, y = best_y;
        for (int a = -50; a <= 50; ++a) {
            for (int b = -50; b <= 50; ++b) {
                const Point at(x + half * a / 50, y + half * b / 50,
                               field.height(x + half * a / 50, y + half * b / 50));
                const double distance = (at - point).norm();
                if (distance < least) least = distance, best_x = at[0], best_y = at[1];
            }
        }
    }
    return least;
}

double summed_volume(const HeightField& field, const Rectangle& r, double level, int count) {
    double sum = 0.0;
    for (int a = 0; a < count; ++a) {
        for (int b = 0; b < count; ++b) {
            const double x = r.x_low + (a + 0.5) * (r.x_high - r.x_low) / count;
            const double y = r.y_low + (b + 0.5) * (r.y_high - r.y_low) / count;
            sum += std::max(field.height(x, y) - level, 0.0);
        }
    }
    return sum * (r.x_high - r.x_low) * (r.y_high - r.y_low) / (count * count);
}

}  // namespace

TEST_CASE("a height field is bilinear between its points and constant beyond them") {
    const auto z = [](double x, double y) { return 2.0 + 0.5 * x - 0.25 * y + 0.125 * x * y; };
    const HeightField field = sampled(4, 3, 2.0, 1.0, -2.0, z);
    for (const double x : {1.0, 1.7, 3.0, 4.9, 7.0}) {
        for (const double y : {-2.0, -0.3, 0.0, 1.1, 2.0})
            CHECK(field.height(x, y) == doctest::Approx(z(x, y)));
    }
    CHECK(field.height(-9.0, 0.5) == doctest::Approx(z(1.0, 0.5)));
    CHECK(field.height(99.0, 0.5) == doctest::Approx(z(7.0, 0.5)));
    CHECK(field.height(2.0, -9.0) == doctest::Approx(z(2.0, -2.0)));
    CHECK(field.height(2.0, 99.0) == doctest::Approx(z(2.0, 2.0)));
    CHECK(field.slope(2.0, 1.0)[0] == doctest::Approx(0.5 + 0.125));
    CHECK(field.slope(2.0, 1.0)[1] == doctest::Approx(-0.25 + 0.25));
    CHECK(field.slope(0.0, 1.0)[0] == 0.0);
    CHECK(field.slope(2.0, 5.0)[1] == 0.0);
    CHECK(field.greatest() == doctest::Approx(z(7.0, 2.0)));
    CHECK(field.least() == doctest::Approx(z(1.0, 2.0)));
}

TEST_CASE("one row of points is the same for all y, one point a level") {
    const HeightField line = sampled(5, 1, 1.0, 0.0, 0.0, [](double x, double) { return x * x; });
    CHECK(line.height(1.5, -100.0) == doctest::Approx(2.5));
    CHECK(line.height(1.5, 100.0) == doctest::Approx(2.5));
    CHECK(line.slope(1.5, 7.0)[0] == doctest::Approx(3.0));
    CHECK(line.slope(1.5, 7.0)[1] == 0.0);
    const HeightField level{1.0, 1, 1, {4.0}};
    CHECK(level.height(-3.0, 8.0) == 4.0);
    CHECK(signed_distance(level, Point(3.0, 4.0, 1.0)) == doctest::Approx(-3.0));
    CHECK(volume_above(level, {-1.0, -2.0, 3.0, 4.0}, 1.0) == doctest::Approx(72.0));
}

TEST_CASE("the distance to a plane is exact away from its edges") {
    const HeightField plane =
        sampled(40, 30, 1.0, -20.0, -15.0, [](double x, double y) { return 0.3 * x - 1.2 * y; });
    const double cosine = 1.0 / std::sqrt(1.0 + 0.09 + 1.44);
    for (const double height : {-4.0, -0.1, 0.0, 0.5, 5.0}) {
        CHECK(signed_distance(plane, Point(0.3, 0.7, 0.09 - 0.84 + height)) ==
              doctest::Approx(height * cosine).epsilon(1e-12));
    }
}

TEST_CASE("the distance to a height field is never above the true one and near the surface equal to it") {
    const HeightField field = hills();
    double worst_near = 1.0, worst = 1.0;
    for (double x = -2.3; x < 21.0; x += 1.37) {
        for (double y = -6.1; y < 13.0; y += 2.21) {
            for (const double over : {-6.0, -2.0, -0.5, -1e-3, 1e-3, 0.5, 2.0, 6.0}) {
                const Point point(x, y, field.height(x, y) + over);
                const double found = signed_distance(field, point);
                const double truth = searched_distance(field, point);
                CAPTURE(point.transpose());
                CHECK((found < 0.0) == (over < 0.0));
                CHECK(std::abs(found) <= truth * (1.0 + 1e-9));
                const double share = std::abs(found) / truth;
                worst = std::min(worst, share);
                if (std::abs(over) < 0.01) worst_near = std::min(worst_near, share);
            }
        }
    }
    MESSAGE("least share of the true distance " << worst << ", 1 mm from the surface " << worst_near);
    CHECK(worst_near > 0.999);
    CHECK(worst > 0.97);
}

TEST_CASE("a distance beyond what is asked for is told as that") {
    const HeightField field = hills();
    for (const double over : {-30.0, -1.0, 0.3, 2.0, 50.0}) {
        const Point point(6.0, 2.0, field.height(6.0, 2.0) + over);
        const double whole = signed_distance(field, point);
        CHECK(signed_distance(field, point, 1.5) == doctest::Approx(std::clamp(whole, -1.5, 1.5)));
    }
}

TEST_CASE("the volume above a level is the integral of the height above it") {
    const HeightField field = hills();
    for (const Rectangle& r : {Rectangle{2.0, -2.0, 15.0, 8.0}, Rectangle{-3.0, -9.0, 25.0, 14.0},
                               Rectangle{4.1, 0.3, 4.7, 0.4}, Rectangle{-4.0, -8.0, -1.0, -5.0}}) {
        for (const double level : {-20.0, -1.0, 0.5, 2.0, 4.0, 50.0}) {
            const double whole = (r.x_high - r.x_low) * (r.y_high - r.y_low);
            CHECK(volume_above(field, r, level) ==
                  doctest::Approx(summed_volume(field, r, level, 1500)).epsilon(2e-5).scale(whole));
        }
    }
}

TEST_CASE("volumes of a wedge and of a saddle are those in closed form") {
    // z = x − y over the unit square: ∫ max(x − y, 0) = 1/6.
    const HeightField wedge = sampled(2, 2, 1.0, 0.0, 0.0, [](double x, double y) { return x - y; });
    CHECK(volume_above(wedge, {0.0, 0.0, 1.0, 1.0}, 0.0) == doctest::Approx(1.0 / 6.0).epsilon(1e-12));
    // z = (x − ½)(y − ½): positive on two quarters, of 1/64 each.
    const HeightField saddle =
        sampled(2, 2, 1.0, 0.0, 0.0, [](double x, double y) { return (x - 0.5) * (y - 0.5); });
    CHECK(volume_above(saddle, {0.0, 0.0, 1.0, 1.0}, 0.0) == doctest::Approx(1.0 / 32.0).epsilon(1e-12));
    // z = xy above ¼: ∫ over x from ¼ to 1 of (x − ¼)²/(2x) = ½ [x²/2 − x/2 + ln(x)/16].
    const HeightField product = sampled(2, 2, 1.0, 0.0, 0.0, [](double x, double y) { return x * y; });
    const double exact = 0.5 * ((0.5 - 0.5 + 0.0) - (1.0 / 32 - 1.0 / 8 + std::log(0.25) / 16));
    CHECK(volume_above(product, {0.0, 0.0, 1.0, 1.0}, 0.25) == doctest::Approx(exact).epsilon(1e-12));
    for (const double near : {1e-1, 1e-2, 1e-3, 1e-5, 1e-9}) {  // two edges that cross zero side by side
        const HeightField fan = sampled(2, 2, 1.0, 0.0, 0.0, [&](double x, double y) {
            return (x - 0.5) * (1.0 - y) + y * (2.0 * near);
        });
        const auto below = [&](double x) {  // along y from x − ½ to 2 near
            const double a = x - 0.5, b = 2.0 * near;
            return a >= 0.0 ? 0.5 * (a + b) : 0.5 * b * b / (b - a);
        };
        double sum = 0.0;
        for (int n = 0; n < 2000000; ++n) sum += below((n + 0.5) / 2e6) / 2e6;
        CHECK(volume_above(fan, {0.0, 0.0, 1.0, 1.0}, 0.0) == doctest::Approx(sum).epsilon(1e-9));
    }
    // Between two levels.
    CHECK(volume_above(wedge, {0.0, 0.0, 1.0, 1.0}, -2.0) - volume_above(wedge, {0.0, 0.0, 1.0, 1.0}, -1.5) ==
          doctest::Approx(0.5));
}
