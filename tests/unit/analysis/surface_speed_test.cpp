#include "analysis/surface_speed.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/types.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

struct Water {
    std::vector<float> points, velocity, volume;
    std::vector<std::uint8_t> material;

    void add(float x, float y, float z, std::array<float, 3> v, Material what = Material::water) {
        points.insert(points.end(), {x, y, z});
        velocity.insert(velocity.end(), v.begin(), v.end());
        volume.push_back(0.25f);
        material.push_back(static_cast<std::uint8_t>(what));
    }
    std::vector<float> speed(const PlaceGrid& places) const {
        return surface_speed({points, volume, material}, velocity, places);
    }
};

}  // namespace

TEST_CASE("the speed of the surface is that of the water within a cell of it") {
    Water water;
    for (int i = 0; i < 8; ++i) {
        for (int k = 0; k < 10; ++k) {
            const float x = 0.25f + 0.5f * static_cast<float>(i), z = 0.25f + 0.5f * static_cast<float>(k);
            water.add(x, 0.0f, z, {z > 4.0f ? 3.0f : 1.0f, 0.0f, z > 4.0f ? -4.0f : 0.0f});
        }
    }
    water.add(0.5f, 0.0f, 4.9f, {100.0f, 0.0f, 0.0f}, Material::ice);
    const std::vector<double> x{0.5, 1.5, 2.5, 3.5}, y{0.0};
    const std::vector<float> level{5.0f, 5.0f, std::nanf(""), 2.0f};
    const auto speed = water.speed({x, y, level, 1.0});
    CHECK(speed[0] == doctest::Approx(5.0));
    CHECK(speed[1] == doctest::Approx(5.0));
    CHECK(std::isnan(speed[2]));
    CHECK(speed[3] == doctest::Approx(1.0));
}

TEST_CASE(
    "in 3D each place has its own water, opposite motions cancel, and what lies outside counts nowhere") {
    Water water;
    water.add(0.6f, 0.4f, 1.0f, {2.0f, 0.0f, 0.0f});
    water.add(0.6f, 1.4f, 1.0f, {0.0f, 6.0f, 0.0f});
    water.add(0.4f, 1.6f, 1.2f, {0.0f, -2.0f, 0.0f});
    water.add(-0.6f, 0.5f, 1.0f, {9.0f, 0.0f, 0.0f});
    water.add(0.5f, 2.6f, 1.0f, {9.0f, 0.0f, 0.0f});
    const std::vector<double> x{0.5, 1.5}, y{0.5, 1.5};
    const std::vector<float> level(4, 1.0f);
    const auto speed = water.speed({x, y, level, 1.0});
    CHECK(speed[0] == 2.0f);
    CHECK(std::isnan(speed[1]));
    CHECK(speed[2] == 2.0f);
    CHECK(std::isnan(speed[3]));
    CHECK(std::isnan(Water{}.speed({x, y, level, 1.0})[0]));
}
