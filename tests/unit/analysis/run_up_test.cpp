#include "analysis/run_up.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace tidewater::analysis;

namespace {

// A beach of slope 1 : 10 from x = 50 m on; still water 2 m deep meets it at x = 70 m.
struct Beach {
    std::vector<double> x, bed, elevation;

    explicit Beach(double eta) {
        for (int i = 0; i < 100; ++i) {
            x.push_back(i + 0.5);
            bed.push_back(std::max(0.0, 0.1 * (x.back() - 50.0)));
            elevation.push_back(2.0 + eta > bed.back() ? eta : none);
        }
    }
};

constexpr Shore to_the_right{.to_the_right = true, .still_level = 2.0, .depth_of_open_water = 0.5};

}  // namespace

TEST_CASE("a level surface meets the beach at its own height") {
    for (const double eta : {-0.83, -0.1, 0.0, 0.042, 0.9}) {
        const Beach beach(eta);
        const Waterline line = find_waterline(beach.x, beach.bed, beach.elevation, to_the_right);
        CHECK(line.height == doctest::Approx(eta));
        CHECK(line.x == doctest::Approx(70.0 + 10.0 * eta));
        CHECK(!line.at_wall);
    }
}

TEST_CASE("a shore to the left is the mirror image") {
    Beach beach(0.3);
    std::ranges::reverse(beach.bed);
    std::ranges::reverse(beach.elevation);
    Shore left = to_the_right;
    left.to_the_right = false;
    CHECK(find_waterline(beach.x, beach.bed, beach.elevation, left).x == doctest::Approx(100.0 - 73.0));
}

TEST_CASE("drops and pools beyond a dry place do not count, nor do gaps in the open water") {
    Beach beach(0.2);
    beach.elevation[85] = 1.9;
    beach.elevation[20] = none;
    CHECK(find_waterline(beach.x, beach.bed, beach.elevation, to_the_right).height == doctest::Approx(0.2));
}

TEST_CASE("the waterline is no farther out than the dry place") {
    Beach beach(0.0);
    beach.elevation[69] = 1.5;  // the front of a bore
    const Waterline line = find_waterline(beach.x, beach.bed, beach.elevation, to_the_right);
    CHECK(line.x == doctest::Approx(70.5));
    CHECK(line.height == doctest::Approx(0.05));
}

TEST_CASE("where water has drawn back beyond the open water the next wet place inward counts") {
    const Beach beach(-1.8);
    CHECK(find_waterline(beach.x, beach.bed, beach.elevation, to_the_right).height == doctest::Approx(-1.8));
}

TEST_CASE("at a wall the outermost elevation counts") {
    const std::vector<double> x{0.5, 1.5, 2.5}, bed(3, 0.0), eta{0.1, 0.2, 0.3};
    const Waterline line = find_waterline(x, bed, eta, to_the_right);
    CHECK(line.at_wall);
    CHECK(line.height == 0.3);
    CHECK(line.x == 2.5);
}

TEST_CASE("without water or open water there is no waterline") {
    CHECK(std::isnan(find_waterline({}, {}, {}, to_the_right).height));
    const std::vector<double> x{0.5, 1.5}, shallow{1.8, 1.9}, deep{0.0, 0.0}, dry{none, none}, wet{0.0, 0.0};
    CHECK(std::isnan(find_waterline(x, deep, dry, to_the_right).height));
    CHECK(std::isnan(find_waterline(x, shallow, wet, to_the_right).height));
}
