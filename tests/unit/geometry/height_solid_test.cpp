#include "geometry/height_solid.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace tidewater::geometry;

namespace {

// A fjord's ground, and ice on it that ends in a cliff a spacing wide.
HeightField sampled(double (*height)(double, double)) {
    HeightField field{.spacing = 12.5, .nx = 81, .ny = 41, .heights = {}};
    for (int i = 0; i < field.nx; ++i) {
        for (int j = 0; j < field.ny; ++j)
            field.heights.push_back(height(i * field.spacing, j * field.spacing));
    }
    return field;
}

double ground(double x, double y) {
    return 60.0 + 0.05 * x + 150.0 * std::pow((y - 250.0) / 250.0, 4) + 5.0 * std::sin(x / 40.0);
}
double ice(double x, double y) { return x > 700.0 + 60.0 * std::sin(y / 70.0) ? 0.0 : 300.0 - 0.1 * x; }

}  // namespace

TEST_CASE("the volume between two fields is that of their columns") {
    const HeightField bed = sampled(ground), top = sampled(ice);
    const Extent box{{0, 0, 0}, {1000, 500, 400}};
    const Solid between = without(below(top), below(bed));
    double columns = 0.0;
    const double step = 1.0;
    for (double x = 0.5 * step; x < 1000.0; x += step) {
        for (double y = 0.5 * step; y < 500.0; y += step)
            columns += step * step * std::max(top.height(x, y) - bed.height(x, y), 0.0);
    }
    const double found = volume(between, box, 12.5, 2, 3);
    MESSAGE("off by " << found / columns - 1.0);
    CHECK(found / columns == doctest::Approx(1.0).epsilon(5e-4));
}

TEST_CASE("far from a field its body's distance is a bound, near to it that to the surface") {
    const HeightField bed = sampled(ground);
    const Solid body = below(bed);
    for (int n = 0; n < 2000; ++n) {
        const auto share = [n](double step) { return std::fmod(0.5 + n * step, 1.0); };
        const Point at(1000.0 * share(0.8191725), 500.0 * share(0.6710436), 400.0 * share(0.5497005));
        const double exact = signed_distance(bed, at, 200.0), found = body(at);
        CHECK(std::abs(found) <= std::abs(exact) + 1e-9);
        CHECK((found > 0.0) == (exact > 0.0));
    }
}
