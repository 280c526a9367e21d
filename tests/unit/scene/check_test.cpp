#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;
using Lines = std::vector<std::string>;

namespace {

Lines warnings(const Sets& sets) { return scene_warnings(read_text_as_scene(block_scene, sets)); }

}  // namespace

TEST_CASE("walls lie on cell edges, and the nearest size that does is told") {
    CHECK(set_problem("domain.size=[16.004, 1]") ==
          "16.004 m along x is not a whole number of cells of 0.01 m; walls lie on cell edges, the nearest "
          "is 16 m");
    CHECK(problem(water_scene_3d, {"domain.size=[4, 2.07, 1.02]"}) ==
          "--set domain.size=[4, 2.07, 1.02]: 2.07 m along y is not a whole number of cells of 0.1 m; walls "
          "lie on cell "
          "edges, the nearest is 2.1 m\n"
          "--set domain.size=[4, 2.07, 1.02]: 1.02 m along z is not a whole number of cells of 0.1 m; walls "
          "lie on cell "
          "edges, the nearest is 1 m");
}

TEST_CASE("a size that is a whole number of cells but for rounding is in order") {
    CHECK(problem(water_scene_3d, {"domain.size=[0.7, 0.9, 1.1]"}) == "");
    CHECK(set_problem("domain.size=[16.000000001, 1]") == "");
}

TEST_CASE("the cell size must resolve the thinnest thing, which is named with the largest size that works") {
    CHECK(set_problem("domain.cell_size=0.1") ==
          "0.1 m is too coarse for the block, 0.25 m thick (block.size): it needs 4 cells, so 0.0625 m at "
          "most");
    CHECK(set_problem("water.depth=0.03") ==
          "a.toml:4: domain.cell_size: 0.01 m is too coarse for the water, 0.03 m thick (water.depth): it "
          "needs 4 cells, "
          "so 0.0075 m at most");
    CHECK(set_problem("water.length=0.02") ==
          "a.toml:4: domain.cell_size: 0.01 m is too coarse for the water, 0.02 m thick (water.length): it "
          "needs 4 "
          "cells, so 0.005 m at most");
    CHECK(problem(water_scene_3d, {"domain.size=[4, 0.2, 1]"}) ==
          "a.toml:4: domain.cell_size: 0.1 m is too coarse for the tank, 0.2 m thick (domain.size): it needs "
          "4 cells, "
          "so 0.05 m at most");
}

TEST_CASE("a thing of exactly four cells is resolved") {
    CHECK(set_problem("water.depth=0.04") == "");
    CHECK(problem(water_scene_3d, {"water.depth=0.4", "domain.size=[4, 0.4, 1]"}) == "");
}

TEST_CASE("gauges of both stages lie inside the tank") {
    CHECK(set_problem("simulate.gauges=[0, 16]") == "");
    CHECK(set_problem("simulate.gauges=[2, 20]") ==
          "outside the tank, which ends at x = 16 m: 20; move or remove what is");
    CHECK(set_problem("postprocess.gauges=[20, 2, 30]") ==
          "outside the tank, which ends at x = 16 m: 20, 30; move or remove what is");
}

TEST_CASE("snapshots are no further apart than the run is long, and rows may be") {
    CHECK(set_problem("simulate.snapshot_interval=10") == "");
    CHECK(set_problem("simulate.snapshot_interval=11") ==
          "11 s is longer than the run of 10 s (simulate.end_time); shorten it");
    CHECK(set_problem("simulate.gauge_interval=11") == "");
}

TEST_CASE("a cell size that would need more particles than can be numbered is told") {
    CHECK(set_problem("domain.cell_size=1e-5") ==
          "would need 325000000000 particles, 3200000 along the tank; use a larger domain.cell_size");
    CHECK(set_problem("domain.cell_size=1e-300").find("use a larger domain.cell_size") != std::string::npos);
    CHECK(problem(water_scene_3d, {"domain.cell_size=0.0005", "water.depth=0.001"}).find("would need") ==
          std::string::npos);
    CHECK(problem(water_scene_3d, {"domain.cell_size=0.002"}) ==
          "--set domain.cell_size=0.002: would need 4000000000 particles, 4000 along the tank; use a larger "
          "domain.cell_size");
    CHECK(problem(water_scene_3d, {"domain.cell_size=0.0025"}) == "");
}

TEST_CASE("a check is left out where a key that it needs is wrong") {
    CHECK(problems(block_scene, {"domain.cell_size=x", "block.center=[20, 0.5]"}) ==
          Lines{"--set domain.cell_size=x: needs a number in m, e.g. cell_size = 0.01; got text \"x\""});
    CHECK(problems(block_scene, {"effects=[\"lava\"]", "water.depth=9"}).size() == 1);
    CHECK(problems(block_scene, {"dimension=5", "domain.size=[1]"}).size() == 1);
}

TEST_CASE("time steps that may be unstable are warned of, in 3D earlier") {
    CHECK(warnings({"simulate.cfl=0.7"}).empty());
    CHECK(warnings({"simulate.cfl=0.8"}) ==
          Lines{"simulate.cfl: 0.8 is more than 0.71, up to which steps are stable in 2D; 0.5 is safe"});
    CHECK(scene_warnings(read_text_as_scene(water_scene_3d, {"simulate.cfl=0.6"})) ==
          Lines{"simulate.cfl: 0.6 is more than 0.58, up to which steps are stable in 3D; 0.5 is safe"});
}

TEST_CASE("pictures after the run's end are warned of and are no error") {
    CHECK(warnings({"postprocess.picture_times=[0, 10]"}).empty());
    CHECK(warnings({"postprocess.picture_times=[1, 11, 12]"}) ==
          Lines{"postprocess.picture_times: later than simulate.end_time = 10 s: 11, 12; the last snapshot "
                "is drawn instead"});
}

TEST_CASE("gauges have the coordinates that their dimension needs, inside the tank") {
    CHECK(set_problem("simulate.gauges=[2, 17, 18]") ==
          "outside the tank, which ends at x = 16 m: 17, 18; move or remove what is");
    CHECK(set_problem("simulate.gauges=[[2, 0.5]]") == "each needs its x; wrong: [[2, 0.5]]");
    CHECK(set_problem("simulate.pressure_gauges=[[2, 0.5], [3]]") == "each needs [x, z]; wrong: [3]");
    CHECK(set_problem("simulate.pressure_gauges=[[2, 0.5], [3, 1.5]]") ==
          "outside the tank, which ends at z = 1 m: [3, 1.5]; move or remove what is");
    CHECK(set_problem("simulate.pressure_gauges=[[2, -0.5]]") ==
          "-0.5 m is out of range; it must be at least 0 m");
    CHECK(problem(water_scene_3d, {"simulate.gauges=[[2, 2.5]]"}).find("ends at y = 2 m: [2, 2.5]") !=
          std::string::npos);
    CHECK(problem(water_scene_3d, {"simulate.pressure_gauges=[[2, 0.5]]"}).find("each needs [x, y, z]") !=
          std::string::npos);
}

TEST_CASE(
    "rows without an interval of their own come ten to a snapshot, but not faster than sound crosses ten "
    "cells") {
    const auto interval = [](const Sets& sets) {
        return row_interval(read_text_as_scene(block_scene, sets));
    };
    CHECK(interval({"simulate.gauge_interval=0.03"}) == 0.03);
    CHECK(interval({"simulate.snapshot_interval=1", "water.sound_speed=100"}) == doctest::Approx(0.1));
    CHECK(interval({"simulate.snapshot_interval=1.1", "water.sound_speed=100"}) == doctest::Approx(0.2));
    // Cells of 0.01 m: 10 Δx/c = 0.004 s.
    CHECK(interval({"simulate.snapshot_interval=0.01", "water.sound_speed=25"}) == doctest::Approx(0.005));
}

TEST_CASE("rows that no disk would hold are refused, with an interval that is not") {
    CHECK(set_problem("simulate.gauge_interval=1e-12") ==
          "1e-12 s gives more than 10 million rows in the run of 10 s (simulate.end_time); make it at least "
          "1e-06 s, or 0 for one that fits the scene");
    CHECK(set_problem("simulate.gauge_interval=1e-06") == "");
}
