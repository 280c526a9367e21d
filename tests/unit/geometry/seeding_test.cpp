#include "geometry/seeding.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>

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
