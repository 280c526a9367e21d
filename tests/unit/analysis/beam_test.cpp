#include "analysis/beam.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace tidewater::analysis;

namespace {

constexpr double strength = 0.5e6;  // Pa

Overhang overhang(double height, double ratio) { return {.height = height, .depth = ratio * height}; }

// The moment of the load about the root, summed piece by piece, over the section modulus.
double summed_stress(const Overhang& o, double length) {
    constexpr int pieces = 10000;
    const double step = length / pieces;
    double moment = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const double load = (o.ice_density * o.height - o.water_density * o.depth) * o.gravity;
        moment += load * step * (i + 0.5) * step;
    }
    return std::abs(moment) / (o.height * o.height / 6.0);
}

}  // namespace

TEST_CASE("lengths are those of the table for 0.5 MPa and densities of 900 and 1000") {
    struct Row {
        double ratio;
        std::array<double, 4> paper, beam;
    };
    constexpr std::array heights{40.0, 120.0, 200.0, 400.0};
    constexpr std::array rows{Row{0.0, {.972, .561, .434, .307}, {.687, .397, .307, .217}},
                              Row{0.2, {1.102, .636, .493, .348}, {.779, .450, .348, .246}},
                              Row{0.4, {1.303, .753, .583, .412}, {.922, .532, .412, .291}},
                              Row{0.7, {2.061, 1.19, .922, .652}, {1.457, .841, .652, .461}},
                              Row{0.8, {2.915, 1.683, 1.303, .922}, {2.061, 1.19, .922, .652}},
                              Row{1.0, {2.915, 1.683, 1.303, .922}, {2.061, 1.19, .922, .652}}};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const Overhang o = overhang(heights[i], row.ratio);
            CHECK(std::abs(paper_length_ratio(o, strength) - row.paper[i]) < 6e-4);
            CHECK(std::abs(beam_length_ratio(o, strength) - row.beam[i]) < 6e-4);
        }
    }
}

TEST_CASE("the surface stress is the load's moment over the section modulus, above and below balance") {
    for (const double ratio : std::array{0.0, 0.5, 1.0}) {
        const Overhang o = overhang(120.0, ratio);
        CHECK(surface_stress(o, 70.0) == doctest::Approx(summed_stress(o, 70.0)));
    }
}

TEST_CASE("a beam of the length that breaks has the strength as its stress, and eq. 1 twice that") {
    const Overhang o = overhang(200.0, 0.3);
    CHECK(surface_stress(o, 200.0 * beam_length_ratio(o, strength)) == doctest::Approx(strength));
    CHECK(surface_stress(o, 200.0 * paper_length_ratio(o, strength)) == doctest::Approx(2.0 * strength));
}

TEST_CASE("the water leaves all of the weight of a dry beam, none in balance, less than none above") {
    CHECK(load_share(overhang(40.0, 0.0)) == 1.0);
    CHECK(std::abs(load_share(overhang(40.0, 0.9))) < 1e-15);
    CHECK(load_share(overhang(40.0, 1.0)) == doctest::Approx(-1.0 / 9.0));
    const Overhang in_balance{.height = 2.0, .depth = 1.0, .ice_density = 500.0};
    CHECK(std::isinf(beam_length_ratio(in_balance, strength)));
}

TEST_CASE("water above the ice counts as the formula is written, and not for submerged ice") {
    const Overhang deep = overhang(200.0, 1.2);
    CHECK(load_share(deep) == doctest::Approx(1.0 - 1.2 / 0.9));
    CHECK(load_share(submerged(deep)) == doctest::Approx(1.0 - 1.0 / 0.9));
    CHECK(paper_length_ratio(deep, strength) ==
          doctest::Approx(paper_length_ratio(overhang(200.0, 1.0), strength) / std::sqrt(3.0)));
    CHECK(load_share(submerged(overhang(200.0, 0.3))) == load_share(overhang(200.0, 0.3)));
}
