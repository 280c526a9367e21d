#include "geometry/solid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "geometry/front.h"

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

Solid ball(const Point& middle, double radius) {
    return [=](const Point& point) { return (point - middle).norm() - radius; };
}

const Extent room{{-15, -15, -15}, {15, 15, 15}};

// |d(a) − d(b)| ≤ |a − b|, as a distance that never exceeds the true one must be.
double steepest(const Solid& solid, const Extent& extent) {
    double most = 0.0;
    for (int n = 0; n < 20000; ++n) {
        const auto share = [n](int k) {
            return std::fmod(
                0.5 + n * std::array{0.8191725, 0.6710436, 0.5497005}[static_cast<std::size_t>(k)], 1.0);
        };
        const Point at =
            extent.low + (extent.high - extent.low).cwiseProduct(Point(share(0), share(1), share(2)));
        for (int axis = 0; axis < 3; ++axis) {
            const Point next = at + 1e-3 * Point::Unit(axis);
            most = std::max(most, std::abs(solid(next) - solid(at)) / 1e-3);
        }
    }
    return most;
}

}  // namespace

TEST_CASE("volumes of bodies against closed forms") {
    const Box box{.center = {1.0, -2.0, 0.5}, .half_size = {8.0, 5.0, 3.0}};
    CHECK(volume(box_solid(box), room, 1.0, 2, 3) == doctest::Approx(960.0).epsilon(1e-14));
    Box turned = box;
    turned.angle = 0.3;
    CHECK(volume(box_solid(turned), room, 1.0, 2, 3) / 960.0 == doctest::Approx(1.0).epsilon(2e-4));
    const double sphere = 4.0 / 3.0 * std::numbers::pi * 1000.0;
    CHECK(volume(ball(Point::Zero(), 10.0), room, 1.0, 2, 3) / sphere == doctest::Approx(1.0).epsilon(1e-4));
    const double disc = std::numbers::pi * 100.0;
    CHECK(volume(ball(Point::Zero(), 10.0), room, 1.0, 2, 2) / disc == doctest::Approx(1.0).epsilon(1e-4));
    CHECK(volume(ball(Point::Zero(), 10.0), room, 1.0, 5, 2) / disc == doctest::Approx(1.0).epsilon(1e-5));
}

TEST_CASE("bodies put together have the volumes of sets") {
    const Solid a = ball({-2, 0, 0}, 5.0), b = ball({2, 0, 0}, 5.0);
    const double both = volume(common(a, b), room, 1.0, 3, 3);
    const double lens =
        std::numbers::pi * (2 * 5.0 - 4.0 + 0) * (2 * 5.0 - 4.0) * (16.0 + 4 * 4.0 * 5.0) / (12.0 * 4.0);
    CHECK(both == doctest::Approx(lens).epsilon(1e-3));
    CHECK(volume(without(a, b), room, 1.0, 3, 3) + both ==
          doctest::Approx(4.0 / 3.0 * std::numbers::pi * 125.0).epsilon(1e-3));
    CHECK(volume(without(a, {}), room, 1.0, 3, 3) == volume(a, room, 1.0, 3, 3));
    const Polygon wedge{{0, 0}, {10, 0}, {0, 6}};
    CHECK(volume(prism(wedge, -3.0, 4.0), room, 1.0, 3, 3) == doctest::Approx(210.0).epsilon(1e-4));
}

TEST_CASE("a volume has the same bits on any number of threads") {
    const auto of = [](int threads) {
        const ThreadLimit limit(threads);
        return volume(ball({0.3, 0.2, 0.1}, 9.0), room, 1.0, 2, 3);
    };
    CHECK(of(1) == of(5));
}

TEST_CASE("a notch takes half an ellipse out of a front") {
    const Box box{.center = {0.0, 0.0, 0.0}, .half_size = {12.0, 4.0, 10.0}};
    const Solid ice = with_front(box_solid(box), -12.0, 12.0, {}, {.depth = 6.0, .height = 8.0, .top = 2.0});
    const double taken = std::numbers::pi * 6.0 * 8.0 / 4.0;
    CHECK(480.0 - volume(ice, room, 1.0, 5, 2) == doctest::Approx(taken).epsilon(1e-3));
    CHECK(ice({7.0, 0.0, -2.0}) > 0.0);
    CHECK(ice({5.0, 0.0, -2.0}) < 0.0);
    CHECK(steepest(ice, room) <= 1.0 + 1e-9);
}

TEST_CASE("an irregular cliff lies within its amplitude, keeps the rear and about the volume") {
    const Box box{.center = {0.0, 0.0, 0.0}, .half_size = {100.0, 500.0, 50.0}};
    const Extent all{{-110, -500, -50}, {110, 500, 50}};
    const Cliff cliff{.amplitude = 10.0, .wavelength = 80.0, .wavelength_up = 60.0, .seed = 7};
    const Solid ice = with_front(box_solid(box), -100.0, 100.0, cliff, {});
    double least = 1e9, most = -1e9, mean = 0.0;
    int count = 0;
    for (double y = -495.0; y < 500.0; y += 5.0) {
        for (double z = -49.0; z < 50.0; z += 7.0) {
            CHECK(ice({-99.9, y, z}) < 0.0);
            CHECK(ice({-100.1, y, z}) > 0.0);
            double low = 80.0, high = 120.0;  // the front, by bisection
            while (high - low > 1e-6)
                (ice({0.5 * (low + high), y, z}) < 0.0 ? low : high) = 0.5 * (low + high);
            least = std::min(least, low), most = std::max(most, low), mean += low, ++count;
        }
    }
    CHECK(least > 89.0);
    CHECK(least < 96.0);
    CHECK(most < 111.0);
    CHECK(most > 104.0);
    CHECK(std::abs(mean / count - 100.0) < 1.0);
    CHECK(steepest(ice, all) <= 1.0 + 1e-9);
    CHECK(volume(ice, all, 10.0, 3, 3) == doctest::Approx(200.0 * 1000.0 * 100.0).epsilon(0.01));
}
