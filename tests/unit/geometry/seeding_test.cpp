#include "geometry/seeding.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

openvdb::FloatGrid::Ptr box_grid(const Box& box, double voxel) {
    return make_level_set("box", voxel,
                          {box.center - Point::Constant(box.half_size.norm()),
                           box.center + Point::Constant(box.half_size.norm())},
                          [box](const Point& p) { return signed_distance(box, p); });
}

}  // namespace

TEST_CASE("a level set holds the exact distance inside its band and its sign outside of it") {
    const Box box{{1.03, 0, 0.52}, {1, 0.4, 0.5}, 0.3};
    const auto grid = box_grid(box, 0.05);
    const auto accessor = grid->getConstAccessor();
    for (int x = -10; x < 60; x += 3) {
        for (int z = -20; z < 40; z += 3) {
            const double exact = signed_distance(box, {0.05 * x, 0, 0.05 * z});
            const double stored = static_cast<double>(accessor.getValue({x, 0, z}));
            CHECK(stored == doctest::Approx(std::clamp(exact, -0.15, 0.15)).epsilon(1e-6));
        }
    }
}

TEST_CASE("a body on lattice lines gets exactly its cells' particles, in 2D and 3D") {
    const Seeding seeding{.cell_size = 0.1, .per_axis = 2};
    const Box tank{{0.8, 0, 0.3}, {0.8, 0.4, 0.3}, 0.0};
    const auto flat = seed_points<2>(*box_grid(tank, 0.1), seeding);
    CHECK(flat.size() == 16 * 6 * 4);
    CHECK(flat.front().isApprox(Vector<2, double>(0.025, 0.025)));
    CHECK(flat.back().isApprox(Vector<2, double>(1.575, 0.575)));
    const Box block{{0.8, 0.5, 0.3}, {0.2, 0.3, 0.1}, 0.0};
    CHECK(seed_points<3>(*box_grid(block, 0.1), seeding).size() == 4 * 6 * 2 * 8);
}

TEST_CASE("a turned body gets its volume's worth of particles") {
    const Box block{{1, 0, 1}, {0.4, 0.2, 0.125}, 0.61};
    const auto points = seed_points<2>(*box_grid(block, 0.02), {.cell_size = 0.02, .per_axis = 2});
    CHECK(static_cast<double>(points.size()) * 1e-4 == doctest::Approx(0.2).epsilon(0.02));
    for (const auto& p : points) CHECK(signed_distance(block, {p[0], 0, p[1]}) < 1e-6);
}

TEST_CASE("jitter stays within a particle's share, depends on the seed, and not on threads") {
    const auto grid = box_grid({{0.8, 0, 0.4}, {0.8, 0.4, 0.4}, 0.0}, 0.1);
    Seeding seeding{.cell_size = 0.1, .per_axis = 2, .jitter = 1.0};
    std::vector<Vector<2, double>> serial, parallel;
    {
        const ThreadLimit limit(1);
        serial = seed_points<2>(*grid, seeding);
    }
    {
        const ThreadLimit limit(5);
        parallel = seed_points<2>(*grid, seeding);
    }
    CHECK(serial == parallel);
    for (const auto& p : serial) {
        CHECK(p.minCoeff() > 0.0);
        CHECK(p[0] < 1.6);
        CHECK(p[1] < 0.8);
    }
    seeding.seed = 2;
    CHECK(seed_points<2>(*grid, seeding) != serial);
}

TEST_CASE("a body far thicker than the level set's band is filled to the middle, and not beside it") {
    const Box block{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 0.0};
    const auto grid = box_grid(block, 0.1);
    CHECK(seed_points<3>(*grid, {.cell_size = 0.1, .per_axis = 2}).size() == 20 * 20 * 20 * 8);
    // Level sets of half the cells' size, and of twice, as bodies on a lattice of another pitch.
    CHECK(seed_points<3>(*grid, {.cell_size = 0.2, .per_axis = 2}).size() == 10 * 10 * 10 * 8);
    CHECK(seed_points<3>(*grid, {.cell_size = 0.05, .per_axis = 1}).size() == 40 * 40 * 40);
}

TEST_CASE("blue noise has as many points as the lattice, apart, and the same on any number of threads") {
    const Box block{{1.0, 0.5, 0.4}, {1.0, 0.5, 0.4}, 0.0};
    const auto grid = box_grid(block, 0.1);
    const Seeding seeding{.cell_size = 0.1, .per_axis = 2, .pattern = SeedPattern::blue_noise};
    const auto points = seed_points<3>(*grid, seeding);
    CHECK(points.size() == 20 * 10 * 8 * 8);
    double least = 1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(signed_distance(block, points[i]) < 0.0);
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).norm());
    }
    CHECK(least > 0.7 * 0.05);
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        CHECK(seed_points<3>(*grid, seeding) == points);
    }
    const auto flat = box_grid({{1.0, 0.0, 0.4}, {1.0, 0.5, 0.4}, 0.0}, 0.1);
    CHECK(seed_points<2>(*flat, seeding).size() == 20 * 8 * 4);
    Seeding other = seeding;
    other.stream = 7;
    CHECK(seed_points<3>(*grid, other) == points);
    other.seed = 2;
    CHECK(seed_points<3>(*grid, other) != points);
}

TEST_CASE("points that are not to be kept are left out, the others stay where they are") {
    const auto grid = box_grid({{0.8, 0.5, 0.4}, {0.8, 0.5, 0.4}, 0.0}, 0.1);
    for (const bool placed : {false, true}) {
        for (const auto pattern : {SeedPattern::lattice, SeedPattern::blue_noise}) {
            Seeding seeding{.cell_size = 0.1, .per_axis = 2, .jitter = 0.7, .pattern = pattern};
            if (placed) seeding.place = [](const Point& p) { return Point(p + Point(0.01, 0.0, -0.02)); };
            auto all = seed_points<3>(*grid, seeding);
            const auto keep = [](const Point& p) { return std::abs(p[0] - 0.5) > 0.013; };
            seeding.keep = keep;
            const auto kept = seed_points<3>(*grid, seeding);
            CHECK(kept.size() < all.size());
            std::erase_if(all, [&](const Point& p) { return !keep(p); });
            CHECK(kept == all);
            seeding.keep = [](const Point&) { return false; };
            CHECK(seed_points<3>(*grid, seeding).empty());
        }
    }
}

TEST_CASE("a level set without the metadata of a body is refused by name") {
    auto grid = box_grid({{1, 0, 1}, {0.4, 0.2, 0.125}, 0.0}, 0.05);
    CHECK_THROWS_WITH_AS(body_volume(*grid), doctest::Contains("'box' has no metadata 'volume'"), InputError);
    describe_body(*grid, Material::rigid, 0.2);
    CHECK(body_volume(*grid) == 0.2);
    CHECK(body_material(*grid) == Material::rigid);
}

TEST_CASE("a lattice that is placed by a map fills the body that the map makes, to its edges") {
    // Twice as long and half as high, and moved.
    const Box body{{1.3, 0, 0.25}, {0.8, 0.4, 0.25}, 0.0};
    Seeding seeding{.cell_size = 0.1, .per_axis = 2};
    seeding.place = [](const Point& p) { return Point(0.5 + 2.0 * p[0], p[1], 0.5 * p[2]); };
    seeding.margin = 1.0;
    const auto points = seed_points<2>(*box_grid(body, 0.1), seeding);
    CHECK(points.size() == 16 * 20);
    CHECK(points.front().isApprox(Vector<2, double>(0.55, 0.0125)));
    CHECK(points.back().isApprox(Vector<2, double>(2.05, 0.4875)));
    const Box tall{{1.3, 0.5, 0.25}, {0.8, 0.3, 0.25}, 0.0};
    CHECK(seed_points<3>(*box_grid(tall, 0.1), seeding).size() == 16 * 20 * 12);
}
