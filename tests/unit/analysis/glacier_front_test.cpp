#include "analysis/glacier_front.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <vector>

using namespace tidewater::analysis;

namespace {

// Particles 2 m apart up to x = length(y, z), 20 m wide (0: 2D) and 40 m high.
struct Body {
    std::vector<float> points;
    std::vector<std::uint32_t> members;

    template <class Length>
    Body(double from, double width, const Length& length) {
        for (double z = 1.0; z < 40.0; z += 2.0) {
            for (double y = 1.0; y < std::max(width, 2.0); y += 2.0) {
                for (double x = from + 1.0; x < length(y, z); x += 2.0) {
                    for (const double part : {x, width > 0.0 ? y : 0.0, z})
                        points.push_back(static_cast<float>(part));
                }
            }
        }
        members.resize(points.size() / 3);
        std::iota(members.begin(), members.end(), 0u);
    }
};

}  // namespace

TEST_CASE("the front is the outline of the foremost particles between the heights") {
    const Body body(0.0, 0.0, [](double, double z) { return z < 10.0 ? 120.0 : 100.0; });
    CHECK(find_front(body.points, body.members, {2.0, 15.0, 25.0}).median() == doctest::Approx(100.0));
    CHECK(find_front(body.points, body.members, {2.0, -INFINITY, INFINITY}).median() ==
          doctest::Approx(120.0));
    CHECK(std::isnan(find_front(body.points, body.members, {2.0, 50.0, 60.0}).median()));
    CHECK(std::isnan(find_front(body.points, {}, {2.0, 0.0, 60.0}).median()));
}

TEST_CASE("in 3D each row has its front, and their median is no mean") {
    const Body body(0.0, 20.0,
                    [](double y, double) { return y < 4.0 ? 300.0 : 100.0 + 2.0 * std::floor(y / 2.0); });
    const FrontRows rows = find_front(body.points, body.members, {2.0, 15.0, 25.0});
    REQUIRE(rows.x.size() == 10);
    CHECK(rows.at(0) == doctest::Approx(300.0));
    CHECK(rows.at(5) == doctest::Approx(110.0));
    CHECK(std::isnan(rows.at(-1)));
    CHECK(std::isnan(rows.at(10)));
    CHECK(rows.median() == doctest::Approx(0.5 * (112.0 + 114.0)));
}

TEST_CASE("an iceberg's break is the mean over its height of how far its rear end is behind the front") {
    const Body glacier(0.0, 0.0, [](double, double) { return 200.0; });
    const FrontRows front = find_front(glacier.points, glacier.members, {2.0, 15.0, 25.0});
    const Body upright(140.0, 0.0, [](double, double) { return 200.0; });
    CHECK(break_distance(upright.points, upright.members, front, 2.0) == doctest::Approx(60.0));
    Body inclined(100.0, 0.0, [](double, double) { return 200.0; });
    std::erase_if(inclined.members, [&](std::uint32_t p) {  // 40 m at the base, 80 m at the top
        return inclined.points[3 * p] < 160.0f - inclined.points[3 * p + 2];
    });
    CHECK(break_distance(inclined.points, inclined.members, front, 2.0) ==
          doctest::Approx(60.0).epsilon(0.02));
    CHECK(std::isnan(break_distance(upright.points, upright.members, {}, 2.0)));
    CHECK(std::isnan(break_distance(upright.points, {}, front, 2.0)));
}
