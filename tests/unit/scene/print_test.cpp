#include <doctest/doctest.h>

#include <set>

#include "scene/keys.h"
#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

namespace {

bool part_changes(const std::string& set, Stage stage) {
    const Scene before = read_text_as_scene(block_scene);
    return stage_part(before, stage) != stage_part(read_text_as_scene(block_scene, {set}), stage);
}

// The stages whose part changes: "gsp" for all.
std::string changed_parts(const std::string& set) {
    std::string stages;
    if (part_changes(set, Stage::geometry)) stages += "g";
    if (part_changes(set, Stage::simulate)) stages += "s";
    if (part_changes(set, Stage::postprocess)) stages += "p";
    return stages;
}

// Equal in every key that the stage or one before it reads.
bool same(const Scene& a, const Scene& b, Stage stage = Stage::postprocess) {
    return scene_hash(a, stage) == scene_hash(b, stage);
}

}  // namespace

TEST_CASE("the resolved text reads back to the same scene and the same text") {
    const Sets awkward{"title=\"q \\\" b \\\\ t \\t ü\"", "domain.gravity=0.1e-7",
                       "block.angle=-33.333333333333336", "water.density=123456789012345678",
                       "simulate.gauges=[0, 1e-300, 3]",  "seed=9223372036854775807"};
    for (const Sets& sets : {Sets{}, awkward}) {
        const Scene scene = read_text_as_scene(block_scene, sets);
        const std::string text = resolved_text(scene);
        const Scene again = read_text_as_scene(text);
        CHECK(resolved_text(again) == text);
        CHECK(same(again, scene));
        CHECK(again.title == scene.title);
        CHECK(again.domain.gravity == scene.domain.gravity);
        CHECK(again.blocks[0].angle == scene.blocks[0].angle);
        CHECK(again.water.model.density == scene.water.model.density);
        CHECK(again.simulate.gauges == scene.simulate.gauges);
    }
}

TEST_CASE("the resolved text reads back in 3D") {
    const Scene scene = read_text_as_scene(water_scene_3d, {"domain.wall_front=stick"});
    CHECK(resolved_text(read_text_as_scene(resolved_text(scene))) == resolved_text(scene));
    CHECK(read_text_as_scene(resolved_text(scene)).domain.wall_front == mpm::WallRule::stick);
}

TEST_CASE(
    "the resolved text shows values with unit and help, and only keys of the scene's effects and dimension") {
    const std::string text = resolved_text(read_text_as_scene(block_scene));
    CHECK(text.find("[water]\ndepth = 0.5                               # m; of the water at rest") !=
          text.npos);
    CHECK(text.find("seed = 1 ") != text.npos);
    CHECK(text.find("wall_front") == text.npos);
    CHECK(resolved_text(read_text_as_scene(water_scene_3d)).find("[block]") == std::string::npos);
    CHECK(resolved_text(read_text_as_scene(water_scene_3d)).find("wall_front") != std::string::npos);
}

TEST_CASE("a change reaches the parts of the stages that read the key, and no others") {
    CHECK(changed_parts("postprocess.gauges=[3]") == "p");
    CHECK(changed_parts("postprocess.picture_width=800") == "p");
    CHECK(changed_parts("title=new") == "p");
    CHECK(changed_parts("simulate.snapshot_interval=0.2") == "sp");
    CHECK(changed_parts("simulate.cfl=0.4") == "s");
    CHECK(changed_parts("simulate.gauges=[3]") == "gsp");  // its picture shows them
    CHECK(changed_parts("water.density=1025") == "s");
    CHECK(changed_parts("block.density=900") == "s");
    CHECK(changed_parts("domain.wall_top=stick") == "s");
    CHECK(changed_parts("seed=2") == "gs");
    CHECK(changed_parts("block.angle=1").starts_with("g"));
    CHECK(changed_parts("water.depth=0.4").starts_with("g"));
    CHECK(changed_parts("domain.cell_size=0.02") == "gsp");
}

TEST_CASE("a key that changes no result changes neither part nor hash, but is printed") {
    CHECK(changed_parts("simulate.checkpoint_interval=7") == "");
    const Scene scene = read_text_as_scene(block_scene, {"simulate.checkpoint_interval=7"});
    CHECK(same(scene, read_text_as_scene(block_scene)));
    CHECK(resolved_text(scene).find("checkpoint_interval = 7 ") != std::string::npos);
}

TEST_CASE("the same value in other words changes no part") {
    CHECK(changed_parts("domain.cell_size=1e-2") == "");
    CHECK(changed_parts("domain.gravity=9.81") == "");
}

TEST_CASE("the hash changes with every key, and not with the text of the file") {
    const Scene scene = read_text_as_scene(block_scene);
    CHECK(scene_hash(scene, Stage::geometry).size() == 16);
    CHECK(same(scene, read_text_as_scene("# a comment\n" + block_scene)));
    CHECK_FALSE(same(scene, read_text_as_scene(block_scene, {"title=other"})));
    CHECK_FALSE(same(scene, read_text_as_scene(block_scene, {"simulate.cfl=0.4"})));
}

TEST_CASE("the hash of a stage changes with the keys of the stages up to it only") {
    const Scene scene = read_text_as_scene(block_scene);
    const Scene later = read_text_as_scene(block_scene, {"postprocess.picture_width=800"});
    CHECK(same(scene, later, Stage::geometry));
    CHECK(same(scene, later, Stage::simulate));
    CHECK_FALSE(same(scene, later, Stage::postprocess));
    const Scene block = read_text_as_scene(block_scene, {"block.angle=1"});
    CHECK_FALSE(same(scene, block, Stage::geometry));
    CHECK_FALSE(same(scene, block, Stage::simulate));
    CHECK_FALSE(same(scene, block, Stage::postprocess));
}

TEST_CASE("the reference tells type, unit, range, default, effect and stages of every key") {
    const std::string text = key_reference();
    for (const Key& key : all_keys()) {
        const bool told = text.find(std::string(key.name) + "\n    ") != text.npos;
        CHECK_MESSAGE(told != key.retired, key.name);
    }
    CHECK(text.find("water.depth\n"
                    "    a number in m, above 0; required, e.g. 0.5; with effect \"water\"\n"
                    "    of the water at rest, above the bottom\n"
                    "    read by geometry, simulate, postprocess\n") != text.npos);
    CHECK(text.find("domain.wall_front\n"
                    "    one of \"slip\", \"stick\" or \"separate\"; default \"slip\"; in 3D\n") !=
          text.npos);
}

TEST_CASE("the values of single keys and of whole sections are told") {
    const Scene scene = read_text_as_scene(block_scene, {"postprocess.picture_width=500"});
    const auto values = [&](std::vector<std::string_view> names) { return values_of(scene, names); };
    CHECK(values({}) == "");
    CHECK(values({"postprocess.picture_width"}) == "postprocess.picture_width = 500\n");
    CHECK(values({"postprocess."}).find("postprocess.picture_width = 500\n") != std::string::npos);
    CHECK(values({"postprocess."}).find("block") == std::string::npos);
    CHECK(values({"postprocess.iceberg_damage"}) == "");  // no fracture
    CHECK_THROWS_AS(values({"postprocess.picture"}), std::invalid_argument);
    CHECK_THROWS_AS(values({"nothing."}), std::invalid_argument);
}
