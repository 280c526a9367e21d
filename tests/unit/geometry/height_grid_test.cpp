#include "geometry/height_grid.h"

#include <doctest/doctest.h>

#include "core/error.h"

using namespace tidewater::geometry;

TEST_CASE("heights come back from a grid, in 2D, in 3D and of one point") {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {5, 1}, {4, 3}}) {
        HeightField field{.spacing = 2.5, .nx = nx, .ny = ny, .heights = {}};
        for (int n = 0; n < nx * ny; ++n) field.heights.push_back(0.25 * n - 1.0);
        const HeightField back = height_field(*height_grid(bed_heights, field));
        CHECK(back.nx == nx);
        CHECK(back.ny == ny);
        CHECK(back.spacing == 2.5);
        CHECK(back.heights == field.heights);
        CHECK(back.height(3.0, 1.0) == field.height(3.0, 1.0));
    }
}

TEST_CASE("what is no grid of heights is told") {
    const auto level_set = make_level_set("water", 1.0, {{-2, -2, -2}, {2, 2, 2}},
                                          [](const Point& p) { return p.norm() - 2.0; });
    CHECK_THROWS_WITH_AS(height_field(*level_set), doctest::Contains("grid 'water' holds no heights"),
                         tidewater::InputError);
}
