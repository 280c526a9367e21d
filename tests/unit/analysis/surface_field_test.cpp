#include "analysis/surface_field.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"
#include "core/types.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

constexpr double cell = 0.1;

struct Cloud {
    std::vector<float> points, volume;
    std::vector<std::uint8_t> material;
    ParticleCloud view() const { return {points, volume, material}; }

    void add(double x, double y, double z, double amount, Material kind) {
        for (const double value : {x, y, z}) points.push_back(static_cast<float>(value));
        volume.push_back(static_cast<float>(amount));
        material.push_back(static_cast<std::uint8_t>(kind));
    }
};

double wave(double x, double y) { return 1.0 + 0.2 * std::sin(2.0 * x + 0.7 * y); }

// Water under wave(x, y), two particles per cell and axis, each anywhere within half of its own share.
Cloud water_of(const Tank& tank) {
    Cloud cloud;
    const double h = 0.5 * cell, share = std::pow(h, tank.dimension);
    std::uint64_t drawn = 0;
    const auto jittered = [&](double middle) {
        return middle + 0.5 * h * (random_uniform(5, 0, drawn++) - 0.5);
    };
    for (double y = 0.5 * h; y < (tank.dimension == 3 ? tank.size[1] : h); y += h) {
        for (double x = 0.5 * h; x < tank.size[0]; x += h) {
            for (double z = 0.5 * h; z < wave(x, y); z += h)
                cloud.add(jittered(x), tank.dimension == 3 ? jittered(y) : 0.0, jittered(z), share,
                          Material::water);
        }
    }
    return cloud;
}

const Tank plane{.dimension = 2, .size = {3.05, 0.0, 2.0}, .cell_size = cell, .still_level = 1.0};
const Tank basin{.dimension = 3, .size = {2.0, 0.7, 2.0}, .cell_size = cell, .still_level = 1.0};

}  // namespace

TEST_CASE("the field has the elevations that surface_elevation reads at the same places") {
    for (Tank tank : {plane, basin, Tank{3, {2.0, 0.1, 2.0}, cell, 1.0}}) {
        const Cloud cloud = water_of(tank);
        const Lattice lattice = cell_lattice(tank);
        std::vector<float> bed;
        std::vector<Place> places;
        for (std::size_t at = 0; at < lattice.count(); ++at) {
            const int i = static_cast<int>(at) % lattice.along, j = static_cast<int>(at) / lattice.along;
            bed.push_back(0.1f * static_cast<float>(i % 3));
            places.push_back({lattice.x(i), lattice.y(j), bed.back()});
        }
        const auto field = surface_field(cloud.view(), tank, bed);
        const auto alone = surface_elevation(cloud.view(), tank, places);
        REQUIRE(field.size() == lattice.count());
        for (std::size_t at = 0; at < field.size(); ++at)
            CHECK(field[at] == doctest::Approx(alone[at]).epsilon(1e-5));
    }
}

TEST_CASE("places are the middles of the whole cells of the tank") {
    const Lattice lattice = cell_lattice(plane);
    CHECK(lattice.along == 30);
    CHECK(lattice.across == 1);
    CHECK(lattice.x(29) == doctest::Approx(2.95));
    CHECK(cell_lattice(basin).across == 7);
    CHECK(cell_lattice(basin).count() == 140);
}

TEST_CASE("a block covers the places within a cell of it, at any depth, and a crumb of ice covers none") {
    Cloud cloud = water_of(plane);
    for (double x = 1.025; x < 1.5; x += 0.05) {
        for (double z = 0.225; z < 0.5; z += 0.05) cloud.add(x, 0.0, z, 0.0025, Material::rigid);
    }
    cloud.add(2.5, 0.0, 1.0, 0.0025, Material::ice);
    const auto field = surface_field(cloud.view(), plane, std::vector<float>(30, 0.0f));
    for (int i = 0; i < 30; ++i) {
        const double x = cell_lattice(plane).x(i);
        const bool within = x > 1.0 - cell && x < 1.5 + cell;
        CHECK(std::isnan(field[static_cast<std::size_t>(i)]) == within);
    }
}

TEST_CASE("dry places and tanks without particles have no elevation") {
    Cloud cloud;
    auto field = surface_field(cloud.view(), plane, std::vector<float>(30, 0.0f));
    for (const float eta : field) CHECK(std::isnan(eta));
    cloud = water_of(plane);
    field = surface_field(cloud.view(), plane, std::vector<float>(30, 1.5f));  // the bed above the water
    for (const float eta : field) CHECK(std::isnan(eta));
}

TEST_CASE("any number of threads gives the same field") {
    const Cloud cloud = water_of(basin);
    const std::vector<float> bed(cell_lattice(basin).count(), 0.0f);
    std::vector<float> one;
    {
        const ThreadLimit limit(1);
        one = surface_field(cloud.view(), basin, bed);
    }
    for (const int threads : {2, 5, 16}) {
        const ThreadLimit limit(threads);
        CHECK(surface_field(cloud.view(), basin, bed) == one);
    }
}

TEST_CASE("six million particles give the field of 20 000 places") {
    Tank tank{.dimension = 3, .size = {400.0, 800.0, 200.0}, .cell_size = 4.0, .still_level = 160.0};
    Cloud cloud;
    for (double y = 1.0; y < tank.size[1]; y += 2.0) {
        for (double x = 1.0; x < tank.size[0]; x += 2.0) {
            for (double z = 1.0; z < tank.still_level; z += 2.0) cloud.add(x, y, z, 8.0, Material::water);
        }
    }
    const std::vector<float> bed(cell_lattice(tank).count(), 0.0f);
    const auto start = std::chrono::steady_clock::now();
    const auto field = surface_field(cloud.view(), tank, bed);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    MESSAGE(cloud.volume.size() << " particles, " << field.size() << " places: " << took.count() << " s");
    for (const float eta : field) CHECK(std::abs(eta) < 0.02f * 4.0f);  // m
}
