#include "analysis/failure_surface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace tidewater::analysis;

namespace {

// A slab 300 m long and 80 m high, its front at x = 310, and in 3D 60 m wide; particles 2 m apart. crack(y,
// z) is how far behind the front it breaks, the particles within 3 m of that between both sides.
template <class Crack>
Calving broken(int dimension, const Crack& crack, bool with_times = true) {
    std::vector<float> points, volume, times;
    std::vector<Side> sides;
    for (double z = 1.0; z < 80.0; z += 2.0) {
        for (double y = 1.0; y < (dimension == 3 ? 60.0 : 2.0); y += 2.0) {
            for (double x = 11.0; x < 310.0; x += 2.0) {
                for (const double part : {x, dimension == 3 ? y : 0.0, z})
                    points.push_back(static_cast<float>(part));
                volume.push_back(dimension == 3 ? 8.0f : 4.0f);
                const double beyond = crack(y, z) - (310.0 - x);  // > 0: in front of the crack
                sides.push_back(std::abs(beyond) < 3.0 ? Side::neither
                                                       : (beyond > 0.0 ? Side::iceberg : Side::rear));
                if (with_times)
                    times.push_back(sides.back() == Side::neither ? static_cast<float>(5.0 - 0.01 * z) : NAN);
            }
        }
    }
    return measure_calving({points, volume, times}, sides, 6.0, {.dimension = dimension, .spacing = 2.0});
}

}  // namespace

TEST_CASE("an upright crack is a plane at 90 degrees, its foot told by its width at the top") {
    for (const int dimension : {2, 3}) {
        const Calving found = broken(dimension, [](double, double) { return 60.0; });
        CHECK(found.plane_angle == doctest::Approx(90.0));
        CHECK(found.plane_misfit == doctest::Approx(0.0));
        CHECK(found.length == doctest::Approx(60.0).epsilon(0.02));
        CHECK(found.foot_angle == doctest::Approx(std::atan2(80.0, found.length_top) * 180.0 / M_PI));
        CHECK(found.time == 6.0);
        CHECK(found.start() == CrackStart::top);
    }
}

TEST_CASE("a plane from the front's foot upward has one angle either way") {
    for (const double angle : {30.0, 45.0, 60.0}) {
        const double slope = 1.0 / std::tan(angle * M_PI / 180.0);
        const Calving found = broken(2, [&](double, double z) { return z * slope; });
        CHECK(std::abs(found.plane_angle - angle) < 1.5);
        CHECK(std::abs(found.foot_angle - angle) < 2.5);
        CHECK(found.plane_misfit < 1.0);
    }
}

TEST_CASE("a crack that is farther behind the front at the base leans over 90 degrees") {
    const Calving found = broken(2, [](double, double z) { return 100.0 - 0.5 * z; });
    CHECK(found.plane_angle == doctest::Approx(180.0 - std::atan(2.0) * 180.0 / M_PI).epsilon(0.01));
}

TEST_CASE("in 3D a plane that runs across the glacier keeps its angle to the horizontal") {
    const Calving found = broken(3, [](double y, double z) { return 40.0 + 0.5 * y + 0.5 * z; });
    // x = 270 - y/2 - z/2: normal (1, 1/2, 1/2)
    CHECK(found.plane_angle ==
          doctest::Approx(std::atan2(std::sqrt(1.25), 0.5) * 180.0 / M_PI).epsilon(0.01));
}

TEST_CASE("without failure times the plane is known and the start is not") {
    const Calving found = broken(
        2, [](double, double) { return 60.0; }, false);
    CHECK(found.plane_angle == doctest::Approx(90.0));
    CHECK(std::isnan(found.start_height));
    CHECK(std::isnan(found.start_time));
}

TEST_CASE("where nothing lies on one side there is no plane") {
    const Calving found = broken(2, [](double, double) { return 500.0; });
    CHECK(std::isnan(found.plane_angle));
    CHECK(std::isnan(found.length));
    CHECK(found.volume > 0.0);
}
