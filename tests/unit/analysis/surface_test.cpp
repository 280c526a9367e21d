#include "analysis/surface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/random.h"
#include "core/types.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

struct Water {
    std::vector<float> points, volume;
    std::vector<std::uint8_t> material;
    ParticleCloud cloud() const { return {points, volume, material}; }

    void add(double x, double y, double z, double amount, Material kind = Material::water) {
        for (const double value : {x, y, z}) points.push_back(static_cast<float>(value));
        volume.push_back(static_cast<float>(amount));
        material.push_back(static_cast<std::uint8_t>(kind));
    }
};

constexpr double cell = 0.1;
const Tank tank2d{.dimension = 2, .size = {6.0, 0.0, 2.0}, .cell_size = cell, .still_level = 1.0};

using Height = std::function<double(double x)>;

// Columns of particles filling the tank up to height(x), spaced about cell / per_axis, each anywhere within
// `jitter` of its own share.
Water fill(const Height& height, int per_axis, double jitter, std::uint64_t seed = 1) {
    Water water;
    const double spacing = cell / per_axis;
    const auto columns = static_cast<int>(std::lround(tank2d.size[0] / spacing));
    std::uint64_t drawn = 0;
    const auto offset = [&] { return 0.5 + jitter * (random_uniform(seed, 0, drawn++) - 0.5); };
    for (int i = 0; i < columns; ++i) {
        const double surface = height((i + 0.5) * spacing);
        const auto rows = static_cast<int>(std::lround(surface / spacing));
        const double step = surface / rows;
        for (int k = 0; k < rows; ++k) {
            water.add((i + offset()) * spacing, 0.0, (k + offset()) * step, spacing * step);
        }
    }
    return water;
}

double elevation_at(const Water& water, double x) {
    return surface_elevation(water.cloud(), tank2d, std::vector<Place>{{x, 0.0}}).front();
}

struct Errors {
    double greatest = 0.0, deviation = 0.0;  // in cells
};

// Of still water at 40 levels between cell lines, read at 60 places including the walls.
Errors still_water_errors(int per_axis, double jitter) {
    Errors errors;
    double squares = 0.0;
    int count = 0;
    for (int level = 0; level < 40; ++level) {
        const double surface = 1.0 + level * cell / 40.0;
        const Water water =
            fill([&](double) { return surface; }, per_axis, jitter, 7 + static_cast<unsigned>(level));
        std::vector<Place> places;
        for (int i = 0; i < 60; ++i) places.push_back({6.0 * i / 59.0, 0.0});
        for (const double elevation : surface_elevation(water.cloud(), tank2d, places)) {
            const double error = std::abs(elevation + 1.0 - surface) / cell;
            errors.greatest = std::max(errors.greatest, error);
            squares += error * error;
            ++count;
        }
    }
    errors.deviation = std::sqrt(squares / count);
    return errors;
}

}  // namespace

TEST_CASE("reads a still surface to a twentieth of a cell wherever it lies between cell lines") {
    for (const int per_axis : {2, 3}) {
        CAPTURE(per_axis);
        CHECK(still_water_errors(per_axis, 0.0).greatest < 0.01);
        CHECK(still_water_errors(per_axis, 0.15).greatest < 0.05);
        CHECK(still_water_errors(per_axis, 0.2).deviation < 0.02);
    }
}

TEST_CASE("reads a fully jittered surface to its own roughness") {
    CHECK(still_water_errors(2, 1.0).deviation < 0.09);
    CHECK(still_water_errors(3, 1.0).deviation < 0.06);
}

TEST_CASE("follows a wave between the columns of cells") {
    const Height wave = [](double x) { return 1.0 + 0.1 * std::cos(2.0 * std::numbers::pi * x / 2.0); };
    const Water water = fill(wave, 2, 0.1);
    for (double x = 0.0; x <= 6.0; x += 0.037) {
        CAPTURE(x);
        CHECK(std::abs(elevation_at(water, x) + 1.0 - wave(x)) < 0.1 * cell);
    }
}

TEST_CASE("reads the places in the order given, each as if it were alone") {
    const Water water = fill([](double x) { return 1.0 + 0.05 * x; }, 2, 0.5);
    const std::vector<Place> places{{5.0, 0.0}, {0.0, 0.0}, {2.5, 0.0}, {2.5, 0.0}, {6.0, 0.0}};
    const auto together = surface_elevation(water.cloud(), tank2d, places);
    for (std::size_t i = 0; i < places.size(); ++i) CHECK(together[i] == elevation_at(water, places[i].x));
    CHECK(surface_elevation(water.cloud(), tank2d, {}).empty());
}

TEST_CASE("needs no particles beyond its reach") {
    const Water water = fill([](double) { return 1.03; }, 2, 1.0);
    Water near;
    for (std::size_t p = 0; p < water.volume.size(); ++p) {
        const double x = water.points[3 * p];
        if (std::abs(x - 3.0) <= surface_reach * cell)
            near.add(x, 0.0, water.points[3 * p + 2], water.volume[p]);
    }
    CHECK(near.volume.size() < water.volume.size() / 10);
    CHECK(elevation_at(near, 3.0) == elevation_at(water, 3.0));
}

TEST_CASE("is not a number where there is no water") {
    CHECK(std::isnan(elevation_at(Water{}, 3.0)));
    const Water left = fill([](double x) { return x < 2.0 ? 1.0 : 0.0; }, 2, 0.0);
    CHECK(std::isnan(elevation_at(left, 4.0)));
    CHECK(elevation_at(left, 1.0) == doctest::Approx(0.0).scale(cell).epsilon(0.02));
}

TEST_CASE("stops at the base of a block and below spray") {
    Water water = fill([](double) { return 0.5; }, 2, 0.0);
    for (double x = 2.0; x < 4.0; x += 0.05) {
        for (double z = 0.525; z < 1.2; z += 0.05) water.add(x, 0.0, z, 0.0025, Material::rigid);
    }
    for (double z = 1.5; z < 1.8; z += 0.05) {
        for (double x = 4.5; x < 5.5; x += 0.05) water.add(x, 0.0, z, 0.0025);
    }
    CHECK(elevation_at(water, 3.0) == doctest::Approx(-0.5).epsilon(0.01));
    CHECK(elevation_at(water, 5.0) == doctest::Approx(-0.5).epsilon(0.01));
}

TEST_CASE("is the lid's height in a full tank, and finds water above a raised bed") {
    CHECK(elevation_at(fill([](double) { return 2.0; }, 2, 0.0), 3.0) == doctest::Approx(1.0));
    Water raised;
    for (double x = 0.025; x < 6.0; x += 0.05) {
        for (double z = 0.625; z < 1.2; z += 0.05) raised.add(x, 0.0, z, 0.0025);
    }
    CHECK(elevation_at(raised, 3.0) == doctest::Approx(0.2).epsilon(0.02));
}

TEST_CASE("reads a slope in three dimensions, in the middle and at the walls") {
    const Tank tank{.dimension = 3, .size = {2.0, 1.0, 1.0}, .cell_size = cell, .still_level = 0.5};
    Water water;
    for (double x = 0.025; x < 2.0; x += 0.05) {
        for (double y = 0.025; y < 1.0; y += 0.05) {
            const double step = (0.5 + 0.1 * y) / 10.0;
            for (int k = 0; k < 10; ++k) water.add(x, y, (k + 0.5) * step, 0.0025 * step);
        }
    }
    const std::vector<Place> places{{1.0, 0.5}, {0.0, 0.8}, {2.0, 0.2}, {0.63, 0.33}};
    const auto elevation = surface_elevation(water.cloud(), tank, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
        CHECK(std::abs(elevation[i] - 0.1 * places[i].y) < 0.05 * cell);
    }
}

TEST_CASE(
    "reads still water in 3D to a twentieth of a cell off the middle too, wherever it lies between cell "
    "lines") {
    const Tank tank{.dimension = 3, .size = {2.0, 1.0, 1.0}, .cell_size = cell, .still_level = 0.5};
    const std::vector<Place> places{{0.0, 0.0},   {0.37, 0.11}, {1.0, 0.5},
                                    {1.33, 0.93}, {2.0, 1.0},   {1.71, 0.06}};
    for (int level = 0; level < 10; ++level) {
        const double surface = 0.5 + level * cell / 10.0;
        const auto rows = std::lround(surface / 0.05);
        const double step = surface / static_cast<double>(rows);
        Water water;
        for (double x = 0.025; x < 2.0; x += 0.05) {
            for (double y = 0.025; y < 1.0; y += 0.05) {
                for (int k = 0; k < rows; ++k) water.add(x, y, (k + 0.5) * step, 0.0025 * step);
            }
        }
        for (const double elevation : surface_elevation(water.cloud(), tank, places))
            CHECK(std::abs(elevation + 0.5 - surface) < 0.05 * cell);
    }
}
