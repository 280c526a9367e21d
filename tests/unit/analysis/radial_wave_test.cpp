#include "analysis/radial_wave.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace tidewater::analysis;

namespace {

// In 1 m of water, 1 m wide, so that thickness and mass / 1000 are S and M.
Slide slide(double froude, double thickness_ratio, double mass_ratio) {
    return {.speed = froude * std::sqrt(9.81),
            .thickness = thickness_ratio,
            .mass = 1000.0 * mass_ratio,
            .depth = 1.0};
}

// F, S and M of Table 1 of the paper (Heller et al. 2019).
const Slide gravity_fall = slide(0.37, 0.5, 0.23), buoyant_fall = slide(0.15, 0.5, 0.23),
            capsize = slide(0.19, 0.25, 0.18);

}  // namespace

TEST_CASE("F, S and M are those of the laboratory's gravity-dominated fall") {
    // A block of 0.5 x 0.5 m, 0.8 m wide, of 184 kg at 1.15 m/s in water 1 m deep; in 2D per m of width.
    for (const double width : {1.0, 0.8}) {
        const Slide block{
            .speed = 1.15, .thickness = 0.5, .mass = 230.0 * width, .width = width, .depth = 1.0};
        CHECK(block.froude() == doctest::Approx(0.37).epsilon(0.01));
        CHECK(block.thickness_ratio() == doctest::Approx(0.5));
        CHECK(block.mass_ratio() == doctest::Approx(0.23));
    }
}

TEST_CASE("the ratios are those of the table in lib/analysis/README.md") {
    const auto& distances = laboratory_distances;
    const auto check = [&](const Slide& of, const auto& expected) {
        for (std::size_t i = 0; i < expected.size(); ++i) {
            CAPTURE(distances[i]);
            CHECK(std::abs(radial_factor(of, distances[i]) - expected[i]) <= 0.00055);
        }
    };
    check(gravity_fall, std::array{0.192, 0.089, 0.050, 0.036, 0.018});
    check(buoyant_fall, std::array{0.134, 0.062, 0.035, 0.025, 0.012});
    check(capsize, std::array{0.092, 0.043, 0.024, 0.017});
}

TEST_CASE("the wave is lower beside the slide's direction, alike on both sides") {
    CHECK(radial_factor(gravity_fall, 5.0, 0.0) == doctest::Approx(radial_factor(gravity_fall, 5.0)));
    CHECK(radial_factor(gravity_fall, 5.0, 60.0) == doctest::Approx(radial_factor(gravity_fall, 5.0, -60.0)));
    // cos 40° to the power of 2 (1 + 1/e) where r/D = 5
    CHECK(radial_factor(gravity_fall, 5.0, 60.0) / radial_factor(gravity_fall, 5.0) ==
          doctest::Approx(std::pow(0.766044, 2.735759)).epsilon(1e-5));
}

TEST_CASE("the impulse product and its waves are the formulas'") {
    const ImpulseProduct level = impulse_product(slide(1.0, 1.0, 1.0), 0.0);
    CHECK(level.value == doctest::Approx(1.0));
    CHECK(level.amplitude == doctest::Approx(4.0 / 9.0));
    CHECK(level.height(1.0) == doctest::Approx(0.75));
    CHECK(level.height(8.0) == doctest::Approx(0.75 * std::pow(0.5, 0.8)));
    CHECK(level.is_valid());
    CHECK(impulse_product(slide(2.0, 1.0, 1.0), 0.0).value == doctest::Approx(2.0));
    CHECK(impulse_product(slide(1.0, 0.25, 1.0), 0.0).value == doctest::Approx(0.5));
    CHECK(impulse_product(slide(1.0, 1.0, 1.0 / 16.0), 0.0).value == doctest::Approx(0.5));
    CHECK(impulse_product(slide(1.0, 1.0, 1.0), 70.0).value == doctest::Approx(std::sqrt(0.5)));
}

TEST_CASE("what the formulas were not fitted to is told, each on its own") {
    const ImpulseProduct lab = impulse_product(gravity_fall);
    CHECK(!lab.froude_is_valid);
    CHECK(lab.thickness_is_valid);
    CHECK(lab.mass_is_valid);
    CHECK(!lab.value_is_valid);
    CHECK(!lab.is_valid());
    CHECK(!impulse_product(slide(1.0, 2.0, 1.0), 30.0).thickness_is_valid);
    CHECK(!impulse_product(slide(1.0, 1.0, 11.0), 30.0).mass_is_valid);
    CHECK(impulse_product(slide(1.0, 1.0, 10.0), 30.0).is_valid());
}

TEST_CASE("a block that does not move makes no wave") {
    const Slide still = slide(0.0, 0.5, 0.23);
    CHECK(radial_factor(still, 2.0) == 0.0);
    CHECK(impulse_product(still).height(2.0) == 0.0);
}
