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

TEST_CASE("the water lies inside the tank") {
    CHECK(set_problem("water.depth=1") == "");
    CHECK(set_problem("water.depth=1.5") ==
          "1.5 m is above the tank's top at 1 m; lower it or raise domain.size");
    CHECK(set_problem("water.length=16") == "");
    CHECK(set_problem("water.length=17") ==
          "17 m is beyond the tank's end at 16 m; shorten it or lengthen domain.size");
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

TEST_CASE("the water's depth follows from the ice's submergence, and the resolved scene reads back") {
    const Scene scene = read_text_as_scene(slab_scene);
    CHECK(scene.water.depth == 12.0);
    CHECK(read_text_as_scene(resolved_text(scene)).water.depth == 12.0);
    CHECK(resolved_text(read_text_as_scene(resolved_text(scene))) == resolved_text(scene));
    CHECK(read_text_as_scene(slab_scene, {"water.submergence=1.2"}).water.depth == doctest::Approx(19.6));
}

TEST_CASE("depth and submergence must agree, and one of them must be there") {
    CHECK(set_problem("water.depth=13", slab_scene) ==
          "13 m, but water.submergence says 12 m; remove one of them");
    CHECK(set_problem("water.submergence=-1", slab_scene) ==
          "a.toml: water.depth: missing; add it, or a water.submergence of 0 or more");
    CHECK(set_problem("water.submergence=0.2") ==
          "is measured on ice, and effects does not name \"ice\"; use water.depth");
}

TEST_CASE("the still water is inside the tank where a submergence gives it, and above the bed somewhere") {
    CHECK(set_problem("water.submergence=3", slab_scene).starts_with("puts the still water at 34 m"));
    tells(flume_scene, {"bed.profile=[0, 1]"}, "1 m is nowhere above the bed");
}
