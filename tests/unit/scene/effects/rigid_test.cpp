#include <doctest/doctest.h>

#include "scene/keys.h"
#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;
using Lines = std::vector<std::string>;

namespace {

// Two blocks above a tank; the second one's keys begin on line 12.
const std::string two_blocks = R"(effects = ["water", "rigid"]
[domain]
size = [16, 1]
cell_size = 0.01
[water]
depth = 0.5
[[block]]
size = [0.5, 0.25]
center = [0.3, 0.7]
density = 900
[[block]]
size = [0.25, 0.25]
center = [2, 0.5]
angle = 30
[simulate]
end_time = 10
snapshot_interval = 0.1
)";

}  // namespace

TEST_CASE("several blocks read in their order, each with its own values and the defaults") {
    const Scene scene = read_text_as_scene(two_blocks);
    REQUIRE(scene.blocks.size() == 2);
    CHECK(scene.blocks[0].center == std::vector<double>{0.3, 0.7});
    CHECK(scene.blocks[0].density == 900.0);
    CHECK(scene.blocks[1].density == 920.0);
    CHECK(scene.blocks[1].angle == 30.0);
    CHECK(scene.blocks[1].velocity == std::vector<double>{0.0, 0.0});
    CHECK(read_text_as_scene(block_scene).blocks.size() == 1);
}

TEST_CASE("one block under a double header is one block") {
    std::string text = block_scene;
    text.replace(text.find("[block]"), 7, "[[block]]");
    CHECK(resolved_text(read_text_as_scene(text)) == resolved_text(read_text_as_scene(block_scene)));
    CHECK(read_text_as_scene(text, {"block.1.angle=5"}).blocks[0].angle == 5.0);
}

TEST_CASE("a setting without a number is every block's, with one that block's, and the last counts") {
    const Scene scene = read_text_as_scene(two_blocks, {"block.density=800", "block.2.angle=10"});
    CHECK(scene.blocks[0].density == 800.0);
    CHECK(scene.blocks[1].density == 800.0);
    CHECK(scene.blocks[0].angle == 0.0);
    CHECK(scene.blocks[1].angle == 10.0);
    CHECK(read_text_as_scene(two_blocks, {"block.2.density=1", "block.density=2"}).blocks[1].density == 2.0);
    CHECK(read_text_as_scene(two_blocks, {"block.density=2", "block.2.density=1"}).blocks[1].density == 1.0);
}

TEST_CASE("several blocks print as sections of their own, and read back to the same text") {
    const Scene scene = read_text_as_scene(two_blocks, {"block.2.velocity=[1, -2]", "block.1.contact=stick"});
    const std::string text = resolved_text(scene);
    CHECK(text.find("[[block]]\nsize = [0.5, 0.25]") != text.npos);
    CHECK(text.find("[[block]]\nsize = [0.25, 0.25]") != text.npos);
    CHECK(text.find("velocity = [1, -2]") != text.npos);
    CHECK(resolved_text(read_text_as_scene(text)) == text);
    const std::string part = stage_part(scene, Stage::geometry);
    CHECK(part.find("block.1.size = [0.5, 0.25]\nblock.2.size = [0.25, 0.25]\n") != part.npos);
}

TEST_CASE("what is wrong with a block is told with its line and its number") {
    CHECK(problems(two_blocks, {"block.2.size=[1, -1]", "block.2.spin=fast"}) ==
          Lines{"--set block.2.size=[1, -1]: -1 m is out of range; it must be above 0 m",
                "--set block.2.spin=fast: needs a number in degrees/s, e.g. spin = 0; got text \"fast\""});
    CHECK(problem(two_blocks + "[[block]]\nsize = [0.3, 0.3]\n") ==
          "a.toml: block.3.center: missing; add it under its [[block]], e.g. center = [0.25, 0.75]");
    CHECK(problem(two_blocks + "[[block]]\nsize = [0.3, 0.3]\ncenter = [5, 0.5]\nangel = 3\n") ==
          "a.toml:21: block.3.angel: unknown key; did you mean block.angle?");
    CHECK(problem(two_blocks + "[[block]]\nsize = [0.3]\ncenter = [5, 0.5]\n") ==
          "a.toml:19: block.3.size: has 1 number, but dimension = 2 needs 2: (x, z)");
}

TEST_CASE("a duplicate key of one of several blocks is told with its line, and a second single header") {
    CHECK(problem(two_blocks + "[[block]]\nsize = [0.3, 0.3]\nsize = [0.3, 0.3]\ncenter = [5, 0.5]\n") ==
          "a.toml:20: block.size: duplicate key; keep one of them");
    CHECK(problem(block_scene + "[block]\nangle = 1\n") ==
          "a.toml:13: duplicate section 'block'; if there are several, write [[block]] above each");
}

TEST_CASE("a setting that is wrong for every block is told once") {
    CHECK(problems(two_blocks, {"block.density=-1"}) ==
          Lines{"--set block.density=-1: -1 kg/m³ is out of range; it must be above 0 kg/m³"});
}

TEST_CASE("a block that does not exist is an error, and so is a number for what stands once") {
    CHECK(problem(two_blocks, {"block.3.angle=1"}) ==
          "--set block.3.angle=1: there is no block 3; the scene has 2, each under a [[block]] of its own");
    CHECK(problem(two_blocks, {"block.0.angle=1"}).find("there is no block 0") != std::string::npos);
    CHECK(problem(two_blocks, {"water.1.depth=1"}) ==
          "--set water.1.depth=1: unknown key; did you mean water.depth?");
}

TEST_CASE("blocks that overlap are told, and blocks that touch are not") {
    CHECK(problem(two_blocks, {"block.2.center=[0.675, 0.7]", "block.2.angle=0"}) == "");
    CHECK(problem(two_blocks, {"block.2.center=[0.6, 0.7]", "block.2.angle=0"}) ==
          "--set block.2.center=[0.6, 0.7]: block 2 and block 1 overlap by 0.075 m; move them "
          "apart");
    // Beyond the first one's corner: their upright bounds overlap, the blocks do not.
    CHECK(problem(two_blocks, {"block.2.center=[0.69, 0.45]", "block.2.angle=45"}) == "");
}

TEST_CASE("a block that overlaps the ice or the ground is told") {
    const Sets ice{"effects=[\"water\", \"rigid\", \"ice\"]", "ice.size=[0.5, 0.5]", "ice.corner=[0, 0]"};
    Sets apart = ice;
    apart.push_back("block.center=[2, 0.7]");
    CHECK(problem(block_scene, apart) == "");
    Sets overlapping = ice;
    overlapping.push_back("block.center=[0.3, 0.6]");
    CHECK(problem(block_scene, overlapping) ==
          "--set block.center=[0.3, 0.6]: the block and the ice overlap by 0.025 m; move them "
          "apart");
    const Sets bed{"effects=[\"water\", \"rigid\", \"bed\"]", "bed.profile=[0, 0.4, 1, 0.5, 3, 0]"};
    CHECK(problem(block_scene, bed) == "");
    Sets low = bed;
    low.push_back("block.center=[1, 0.55]");
    CHECK(problem(block_scene, low) ==
          "--set block.center=[1, 0.55]: the block and the ground (bed.profile) overlap by "
          "0.075 "
          "m; move them apart");
}

TEST_CASE("friction belongs to a contact that slips") {
    CHECK(problem(block_scene, {"block.friction=0.3"}) == "");
    CHECK(problem(two_blocks, {"block.2.contact=stick", "block.2.friction=0.3"}) ==
          "--set block.2.friction=0.3: is not read with contact = \"stick\"; remove it or set contact = "
          "\"slip\"");
}

TEST_CASE("a velocity has a number per dimension, and an empty one is rest") {
    CHECK(read_text_as_scene(block_scene, {"block.velocity=[]"}).blocks[0].velocity ==
          std::vector<double>{0.0, 0.0});
    CHECK(problem(block_scene, {"block.velocity=[1, 2, 3]"}).find("has 3 numbers") != std::string::npos);
}

TEST_CASE("a block of few cells is an error, of less than ten a warning") {
    CHECK(
        problem(two_blocks, {"block.2.size=[0.5, 0.03]"}) ==
        "a.toml:4: domain.cell_size: 0.01 m is too coarse for block 2, 0.03 m thick (block.2.size): it needs "
        "4 cells, so 0.0075 m at most");
    const Lines lines = scene_warnings(read_text_as_scene(two_blocks, {"block.2.size=[0.5, 0.05]"}));
    REQUIRE(lines.size() == 1);
    CHECK(
        lines[0] ==
        "block.2.size: block 2 is 5 cells thick, and its wave will be coarse; cells of 0.005 m would give it "
        "10");
}

TEST_CASE("a block's start counts among the fastest flows") {
    const auto warned = [](const Sets& sets) {
        return !scene_warnings(read_text_as_scene(two_blocks, sets)).empty();
    };
    CHECK_FALSE(warned({"water.sound_speed=40"}));
    CHECK(warned({"water.sound_speed=40", "block.2.velocity=[-3, 4]"}));
    CHECK(warned({"water.sound_speed=40", "block.1.spin=3600"}));
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

TEST_CASE("every transfer, scheme and tension goes with a rigid block") {
    CHECK(problem(block_scene, {"simulate.transfer=\"restored\""}) == "");
    CHECK(problem(block_scene,
                  {"simulate.transfer=\"apic\"", "water.scheme=\"paper\"", "water.tension=\"paper\""}) == "");
}

TEST_CASE("a boundary that blocks do not touch is not named with them") {
    CHECK(problem(block_scene,
                  {"effects=[\"water\", \"rigid\", \"shelf\"]", "shelf.length=2", "shelf.height=0.1"}) ==
          "--set effects=[\"water\", \"rigid\", \"shelf\"]: names \"rigid\" and \"shelf\": a rigid block "
          "touches only water, ice, a bed and the tank's walls so far; remove one of them");
}
