#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;
using Lines = std::vector<std::string>;

namespace {

Lines warnings(const Sets& sets) { return scene_warnings(read_text_as_scene(block_scene, sets)); }

// The speed in the warning of too soft water.
std::string expected_flow(const Sets& sets) {
    const std::string lead = "fastest expected flow, ";
    const std::string line = warnings(sets).at(0);
    const auto start = line.find(lead) + lead.size();
    return line.substr(start, line.find(' ', start) - start);
}

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

TEST_CASE("the water lies inside the tank") {
    CHECK(set_problem("water.depth=1") == "");
    CHECK(set_problem("water.depth=1.5") ==
          "1.5 m is above the tank's top at 1 m; lower it or raise domain.size");
    CHECK(set_problem("water.length=16") == "");
    CHECK(set_problem("water.length=17") ==
          "17 m is beyond the tank's end at 16 m; shorten it or lengthen domain.size");
}

TEST_CASE("a block may touch the walls") {
    CHECK(set_problem("block.center=[0.25, 0.125]") == "");
    CHECK(set_problem("block.center=[15.75, 0.875]") == "");
}

TEST_CASE("a block outside the tank is told with its extent and the tank's") {
    CHECK(set_problem("block.center=[0.2, 0.5]") ==
          "the block lies outside the tank: along x it reaches from -0.05 m to 0.45 m, the tank from 0 m to "
          "16 m; move "
          "block.center or shrink block.size");
    CHECK(set_problem("block.center=[20, 0.9]") ==
          "the block lies outside the tank: along x it reaches from 19.75 m to 20.25 m, the tank from 0 m to "
          "16 m; move "
          "block.center or shrink block.size\n"
          "--set block.center=[20, 0.9]: the block lies outside the tank: along z it reaches from 0.775 m to "
          "1.025 m, "
          "the tank from 0 m to 1 m; move block.center or shrink block.size");
}

TEST_CASE("a block is inside the tank only if its turned corners are") {
    const Sets in_the_middle{"block.center=[0.27, 0.5]", "block.angle=90"};
    CHECK(problem(block_scene, in_the_middle) == "");
    CHECK(problem(block_scene, {"block.center=[0.27, 0.5]", "block.angle=30"})
              .find("along x it reaches from -0.00900635 m to 0.549006 m") != std::string::npos);
    CHECK(problem(block_scene, {"block.center=[0.27, 0.5]", "block.angle=-150"}) ==
          problem(block_scene, {"block.center=[0.27, 0.5]", "block.angle=30"}));
}

TEST_CASE("a block in 3D turns in the x–z plane only") {
    const Sets block{"effects=[\"water\", \"rigid\"]", "block.size=[1, 2, 0.5]", "block.center=[2, 1, 0.5]"};
    CHECK(problem(water_scene_3d, block) == "");
    Sets turned = block;
    turned.push_back("block.angle=90");
    CHECK(problem(water_scene_3d, turned) == "");
    turned[2] = "block.center=[2, 1.1, 0.5]";
    CHECK(problem(water_scene_3d, turned).find("along y it reaches from 0.1 m to 2.1 m") !=
          std::string::npos);
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

TEST_CASE("water that is too soft for the fastest flow is warned of") {
    CHECK(warnings({}).empty());
    CHECK(warnings({"water.sound_speed=23"}).empty());
    CHECK(warnings({"water.sound_speed=20"}) ==
          Lines{"water.sound_speed: 20 m/s is less than 10 times the fastest expected flow, 2.21472 m/s, so "
                "the water will compress by more than 1 %; 23 m/s would do"});
}

TEST_CASE("the fastest flow is that of long waves, of a broken dam, of the block's fall or of its height") {
    CHECK(expected_flow({"water.depth=0.8", "water.sound_speed=1"}) == "2.80143");
    CHECK(expected_flow({"water.length=4", "water.sound_speed=1"}) == "4.42945");
    CHECK(expected_flow({"water.depth=0.1", "water.sound_speed=1", "block.center=[0.3, 0.875]"}) ==
          "3.57113");
    CHECK(expected_flow({"water.depth=0.2", "water.sound_speed=1", "block.center=[0.3, 0.3]",
                         "block.angle=90"}) == "3.13209");
}

TEST_CASE("a depth that no whole number of particle layers fills is warned of with its neighbours") {
    CHECK(warnings({"water.depth=0.505"}).empty());
    CHECK(warnings({"water.depth=0.503"}) ==
          Lines{"water.depth: 0.503 m is not a whole number of particle spacings of 0.005 m, so the still "
                "level is off by up to half of one; 0.5 m and 0.505 m would fit"});
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

namespace {

const std::string slab_scene = R"(effects = ["water", "ice", "fracture", "shelf", "push", "outlet", "settle"]
[domain]
size = [60, 24]
cell_size = 1
[water]
submergence = 0.25
[ice]
size = [34, 8]
corner = [0, 10]
[shelf]
length = 30
height = 10
[push]
speed = 2
[outlet]
width = 12
[simulate]
end_time = 3
snapshot_interval = 0.5
)";

std::string slab_problem(const std::string& set) {
    const std::string line = problem(slab_scene, {set});
    const std::string lead = "--set " + set + ": ";
    return line.starts_with(lead) ? line.substr(lead.size()) : line;
}

}  // namespace

TEST_CASE("the water's depth follows from the ice's submergence, and the resolved scene reads back") {
    const Scene scene = read_text_as_scene(slab_scene);
    CHECK(scene.water.depth == 12.0);
    CHECK(read_text_as_scene(resolved_text(scene)).water.depth == 12.0);
    CHECK(resolved_text(read_text_as_scene(resolved_text(scene))) == resolved_text(scene));
    CHECK(read_text_as_scene(slab_scene, {"water.submergence=1.2"}).water.depth == doctest::Approx(19.6));
}

TEST_CASE("depth and submergence must agree, and one of them must be there") {
    CHECK(slab_problem("water.depth=13") == "13 m, but water.submergence says 12 m; remove one of them");
    CHECK(slab_problem("water.submergence=-1") ==
          "a.toml: water.depth: missing; add it, or a water.submergence of 0 or more");
    CHECK(set_problem("water.submergence=0.2") ==
          "is measured on ice, and effects does not name \"ice\"; use water.depth");
}

TEST_CASE("an effect that has nothing to act on is told") {
    CHECK(problem(block_scene, {"effects=[\"water\", \"rigid\", \"fracture\"]"}) ==
          "--set effects=[\"water\", \"rigid\", \"fracture\"]: names \"fracture\" but not \"ice\", so there "
          "is nothing "
          "that could fracture; add \"ice\" or remove \"fracture\"");
}

TEST_CASE("ice lies inside the tank and on the shelf, not in it") {
    CHECK(slab_problem("ice.corner=[30, 10]") ==
          "the ice ends outside the tank: along x at 64 m, the tank at 60 m; move ice.corner or shrink "
          "ice.size");
    CHECK(slab_problem("ice.corner=[0, 9]")
              .starts_with("the ice reaches into the shelf: its base is at 9 m, the "
                           "shelf's top at 10 m"));
    CHECK(slab_problem("ice.corner=[30, 2]").find("shelf") == std::string::npos);  // beyond it
}

TEST_CASE("a shelf's faces lie on cell edges inside the tank") {
    CHECK(slab_problem("shelf.length=29.5") ==
          "29.5 m is not a whole number of cells of 1 m; its faces lie on cell "
          "edges, the nearest is 30 m");
    CHECK(slab_problem("shelf.length=60") ==
          "60 m fills the tank, 60 m along x; shorten it or enlarge domain.size");
}

TEST_CASE("a crack band needs its energy, and ice that would snap is told") {
    CHECK(slab_problem("fracture.softening=\"crack_band\"").find("fracture.energy: missing") !=
          std::string::npos);
    const auto band =
        read_text_as_scene(slab_scene, {"fracture.softening=\"crack_band\"", "fracture.energy=2000"});
    const auto twice =
        read_text_as_scene(slab_scene, {"fracture.softening=\"crack_band\"", "fracture.energy=4000"});
    CHECK(ice_model(band).hardening == doctest::Approx(2 * ice_model(twice).hardening));
    CHECK(ice_model(read_text_as_scene(slab_scene)).hardening == 3.0);
    const auto snaps = scene_warnings(read_text_as_scene(slab_scene, {"fracture.beta=0.5"}));
    REQUIRE(!snaps.empty());
    CHECK(snaps[0].find("βξ = 1.5") != std::string::npos);
}

TEST_CASE("what would be read wrongly or not at all is told") {
    CHECK(slab_problem("fracture.energy=800").find("is not read with softening") != std::string::npos);
    CHECK(slab_problem("ice.youngs_modulus=1e7").find("fracture.strength: over fracture.beta") !=
          std::string::npos);
    CHECK(slab_problem("water.submergence=3").starts_with("puts the still water at 34 m"));
    CHECK(problems(block_scene,
                   {"effects=[\"water\", \"rigid\", \"shelf\"]", "shelf.length=2", "shelf.height=0.1"})
              .size() == 1);
    const auto warned = scene_warnings(read_text_as_scene(slab_scene, {"simulate.end_time=20"}));
    REQUIRE(!warned.empty());
    CHECK(warned.back().find("meets the right wall") != std::string::npos);
}

TEST_CASE("a wave needs open water, a length that the tank holds and a height within its theory") {
    const std::string standing = R"(effects = ["water", "wave"]
domain.size = [4, 2]
domain.cell_size = 0.05
water.depth = 1
wave.height = 0.1
wave.length = 8
simulate.end_time = 10
simulate.snapshot_interval = 0.1
)";
    const auto told = [&](const Sets& sets) {
        const std::string text = problem(standing, sets);
        return text.substr(text.find(": ") + 2);
    };
    const Sets solitary{"wave.kind=\"solitary\"", "wave.length=0", "wave.center=2"};
    CHECK(problem(standing) == "");
    CHECK(problem(standing, solitary) == "");
    CHECK(problem(standing, {"wave.length=4"}) == "");
    CHECK(told({"wave.length=5"}) ==
          "5 m: the tank of 4 m holds no whole number of halves of it; the nearest length is 4 m");
    CHECK(told({"wave.length=0"}) == "missing; a standing wave needs its length, e.g. length = 8 (m)");
    CHECK(told({"wave.center=1"}) == "is not read with kind = \"standing\"; remove it");
    CHECK(told({"wave.height=0.6"}) ==
          "0.6 m is more than 0.5 of the water's depth, up to which the theory holds; lower it to 0.5 m");
    CHECK(told({"domain.size=[4, 1.05]"}).find("the crest at 1.1 m is above the tank's top at 1.05 m") !=
          std::string::npos);
    CHECK(told({"water.length=3"}) == "3 m is not the whole tank, which a wave needs; remove it");
    CHECK(told({"domain.gravity=0"}).starts_with("0 m/s² makes no waves"));
    CHECK(
        problem(standing, {solitary[0], solitary[1], "wave.center=5"}).find("beyond the tank's end at 4 m") !=
        std::string::npos);
    CHECK(problem(block_scene,
                  {"effects=[\"water\", \"rigid\", \"wave\"]", "wave.height=0.1", "wave.length=32"})
              .find("names \"wave\" and \"rigid\"") != std::string::npos);
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

TEST_CASE("every transfer, scheme and tension goes with a rigid block") {
    CHECK(problem(block_scene, {"simulate.transfer=\"restored\""}) == "");
    CHECK(problem(block_scene,
                  {"simulate.transfer=\"apic\"", "water.scheme=\"paper\"", "water.tension=\"paper\""}) == "");
}
