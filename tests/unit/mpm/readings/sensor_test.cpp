#include "mpm/readings/sensor.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// Off ρ g (D − z) at each point, in ρ g D.
template <int D>
void check_still(const Simulation<D, float>& s, double depth, std::vector<Vector<D, double>> points,
                 double most) {
    const auto pressure = pressure_at<D, float>(s, points);
    REQUIRE(pressure.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double shall = std::max(9810.0 * (depth - points[i][D - 1]), 0.0);
        CAPTURE(points[i].transpose());
        CHECK(std::abs(pressure[i] - shall) < most * 9810.0 * depth);
    }
}

template <int D>
Vector<D, double> point(std::initializer_list<double> coordinates) {
    Vector<D, double> at;
    int axis = 0;
    for (const double along : coordinates) at[axis++] = along;
    return at;
}

}  // namespace

TEST_CASE("reads still water to a hundredth of the foot's pressure: inside, on walls, in corners") {
    for (const double jitter : {0.0, 0.5}) {
        const auto s = make_simulation<2, float>(
            test::tank_start<2>(0.05, {30, 30}, 1.0, 62.0, 0.0, Vector<2, double>::Zero(), 2, jitter));
        check_still<2>(
            s, 1.0,
            {point<2>({0.75, 0.0}), point<2>({0.77, 0.013}), point<2>({0.0, 0.0}), point<2>({1.5, 0.0}),
             point<2>({1.5, 0.003}), point<2>({0.0, 0.41}), point<2>({0.63, 0.37}), point<2>({1.5, 0.9})},
            0.01);
    }
}

TEST_CASE("reads still water in 3D likewise") {
    const auto s = make_simulation<3, float>(test::tank_start<3>(0.1, {10, 8, 12}, 1.0, 62.0));
    check_still<3>(s, 1.0,
                   {point<3>({0.5, 0.4, 0.0}), point<3>({0.0, 0.0, 0.0}), point<3>({1.0, 0.33, 0.0}),
                    point<3>({1.0, 0.8, 0.25}), point<3>({0.27, 0.41, 0.53})},
                   0.01);
}

TEST_CASE("shows nothing where there is no water, and little of a drop") {
    auto start = test::tank_start<2>(0.05, {30, 30}, 0.5, 62.0);
    const auto s = make_simulation<2, float>(start);
    check_still<2>(s, 0.5, {point<2>({0.7, 0.75}), point<2>({0.0, 1.5})}, 1e-9);
    start.bodies[0].points = {point<2>({0.52, 0.5})};
    start.bodies[0].volume = 0.05 * 0.05 / 4.0;
    start.bodies[0].mass = 1000.0 * start.bodies[0].volume;
    start.bodies[0].surface = 1.5;
    const auto drop = make_simulation<2, float>(start);
    const double shown = pressure_at<2, float>(drop, std::vector{point<2>({0.5, 0.5})})[0];
    CHECK(shown > 0.0);
    CHECK(shown < 0.5 * 9810.0);
    CHECK(pressure_at<2, float>(drop, {}).empty());
}
