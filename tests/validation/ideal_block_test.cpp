// What ideal water (tests/support/ideal_block.h) would let the laboratory's blocks do, for comparison with
// tests/validation/README.md, Laboratory.
#include "support/ideal_block.h"

#include <doctest/doctest.h>

#include "support/potential_flow.h"

using namespace tidewater;

namespace {

double off(double measured, double reference) { return measured / reference - 1.0; }

}  // namespace

TEST_CASE("the added masses of blocks in ideal water are those of closed forms and of a grid") {
    // A square of edge 2a deep in water: 4.754 ρ a² along its edges and across them, 0.725 ρ a⁴ turning.
    const test::IdealBlock square{.width = 1.0, .height = 1.0, .depth = 40.0};
    const Eigen::Matrix3d deep = test::added_mass(square, {0.0, 20.0, 0.3});
    MESSAGE("a square: " << deep(1, 1) << " kg/m, " << deep(2, 2) << " kg m");
    CHECK(std::abs(off(deep(0, 0), 4754.0 / 4.0)) < 0.02);
    CHECK(std::abs(off(deep(1, 1), 4754.0 / 4.0)) < 0.02);
    CHECK(std::abs(off(deep(2, 2), 725.0 / 16.0)) < 0.02);
    // A box that floats and one that is under water.
    for (const double bottom : {0.7, 0.3}) {
        const test::PotentialFlow grid(4.0, 1.0, 0.02, {1.8, 2.2, bottom, bottom + 0.4});
        const test::IdealBlock box{.width = 0.4, .height = 0.4};
        const double heave = test::added_mass(box, {0.0, bottom + 0.2, 0.0})(1, 1);
        MESSAGE("bottom " << bottom << ": " << heave << " kg/m, on a grid " << grid.added_mass());
        CHECK(std::abs(off(heave, grid.added_mass())) < 0.06);
    }
}

TEST_CASE("the laboratory's blocks in ideal water") {
    // BF, half of a block twice as wide that is its own image in the wall, until its top is 4 cm below the
    // surface; then the speed with which it would pass the pose that it floats in.
    const test::IdealBlock fall{.width = 1.0, .height = 0.5, .panels = 12};
    const auto rise =
        test::release(fall, {0.0, 0.42, 0.0}, 0.1, [&](const auto& m) { return m.at[1] < 0.7; });
    const test::Pose floating(0.0, fall.depth - 0.21, 0.0);
    const double all = 0.5 * (fall.mass() + test::added_mass(fall, floating)(1, 1));
    MESSAGE("BF: " << rise.back().fastest_point(fall) << " m/s after " << rise.back().time << " s at "
                   << rise.back().at[1] << " m; at most " << std::sqrt(2.0 * 66.0 / all)
                   << " m/s from all of the 66 J/m");
    CHECK(std::abs(off(rise.back().kinetic, test::work_done(fall, rise))) < 0.01);
    // CS, until it lies flat.
    const test::IdealBlock lean{.width = 0.25, .height = 0.8, .panels = 12};
    const double turn = std::numbers::pi / 180.0;
    const auto roll = test::release(lean, {0.0, 0.72326, 35.0 * turn}, 0.04,
                                    [&](const auto& m) { return m.at[2] < 90.0 * turn && m.time < 5.0; });
    double fastest = 0.0;
    for (const auto& m : roll) fastest = std::max(fastest, m.fastest_point(lean));
    MESSAGE("CS: " << fastest << " m/s, lies flat after " << roll.back().time << " s with "
                   << roll.back().kinetic << " J/m at " << roll.back().fastest_point(lean) << " m/s");
    CHECK(std::abs(off(roll.back().kinetic, test::work_done(lean, roll))) < 0.01);
}
