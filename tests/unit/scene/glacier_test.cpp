#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

namespace {

// 300 m of ice, 100 m high, behind 200 m of water.
const std::string glacier_scene = R"(effects = ["water", "ice", "fracture"]
[domain]
size = [500, 150]
cell_size = 2.5
[water]
depth = 50
[ice]
size = [300, 100]
corner = [0, 0]
[simulate]
end_time = 3
snapshot_interval = 0.5
)";

std::string line_of(const Sets& sets, const std::string& text = glacier_scene) { return problem(text, sets); }

void tells(const Sets& sets, const std::string& what) {
    const std::string line = line_of(sets);
    CAPTURE(line);
    CHECK(line.find(what) != std::string::npos);
}

const std::string with_effects = "effects=[\"water\", \"ice\", \"fracture\", ";

// The same scene with the ice by an outline.
std::string without_box() {
    std::string text = glacier_scene;
    const auto size = text.find("size = [300"), simulate = text.find("[simulate]");
    return text.replace(size, simulate - size, "");
}

}  // namespace

TEST_CASE("a glacier with everything on it is in order") {
    CHECK(line_of({with_effects + "\"cliff\", \"undercut\", \"crevasses\", \"cracks\"]", "cliff.amplitude=10",
                   "undercut.depth=10", "undercut.height=20", "crevasses.spacing=90", "cracks.cell_size=40",
                   "cracks.width=1", "cracks.cohesion=0.3"}) == "");
}

TEST_CASE("what shapes ice needs it") {
    tells({"effects=[\"water\", \"crevasses\"]", "crevasses.spacing=90"}, "there is nothing to cut into");
    tells({"effects=[\"water\", \"ice\", \"cracks\"]", "cracks.cell_size=40", "cracks.width=1",
           "cracks.cohesion=0.3"},
          "add \"fracture\" to effects or set 0");
    tells({"ice.base=bed"}, "\"bed\" needs ground to rest on");
    tells({"ice.base=floating", "water.submergence=0.5"}, "needs water of a given water.depth");
}

TEST_CASE("fronts, crevasses and cracks that make no sense are told with what would do") {
    tells({with_effects + "\"cliff\"]", "cliff.amplitude=90"},
          "more than a quarter of the ice's length of 300 m");
    tells({with_effects + "\"cliff\"]", "cliff.amplitude=9", "cliff.wavelength_up=5"},
          "less than 4 cells of 2.5 m");
    tells({with_effects + "\"undercut\"]", "undercut.depth=200", "undercut.height=20"},
          "more than half of the ice's");
    tells({with_effects + "\"undercut\"]", "undercut.depth=10", "undercut.height=20", "undercut.below=60"},
          "between z = -30 m and -10 m, where the ice, from 0 m to 100 m, is not");
    tells({with_effects + "\"crevasses\"]", "crevasses.spacing=15"}, "20 m is the least");
    tells({with_effects + "\"crevasses\"]", "crevasses.spacing=90", "crevasses.depth=[20, 120]"},
          "cuts through the ice, 100 m high");
    tells({with_effects + "\"crevasses\"]", "crevasses.spacing=90", "crevasses.depth=[50, 20]"},
          "is not the least and the greatest");
    tells({with_effects + "\"cracks\"]", "cracks.cell_size=4", "cracks.width=1"},
          "less than 2 grid cells of 2.5 m");
    tells({with_effects + "\"cracks\"]", "cracks.cell_size=40", "cracks.width=25"},
          "must be below half of that");
}

TEST_CASE("an outline gives the box around it, and is told where it is none") {
    const Sets outline{"ice.profile=[0, 0, 0, 100, 280, 100, 300, 60, 290, 0]"};
    const Scene scene = read_text_as_scene(without_box(), outline);
    CHECK(scene.ice.corner == std::vector<double>{0, 0});
    CHECK(scene.ice.size == std::vector<double>{300, 100});
    CHECK(read_text_as_scene(resolved_text(scene)).ice.profile == scene.ice.profile);
    CHECK(resolved_text(read_text_as_scene(resolved_text(scene))) == resolved_text(scene));
    CHECK(line_of({outline[0], "ice.size=[300, 90]"}).find("is not that of ice.profile, [300, 100]") !=
          std::string::npos);
    CHECK(line_of({"ice.profile=[0, 0, 100, 100, 100, 0, 0, 100]"}, without_box())
              .find("crosses itself at x = 50 m") != std::string::npos);
    CHECK(line_of({"ice.profile=[0, 0, 100, 100]"}, without_box()).find("three at least") !=
          std::string::npos);
    CHECK(line_of({}, without_box()).find("ice.size: missing") != std::string::npos);
}

TEST_CASE("profiles are read from files beside the scene, and are then part of it") {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "a.toml") << without_box();
    std::ofstream(folder.path() / "front.csv")
        << "x,z\n# the rear\n0, 0\n0, 100\n\n280; 100\n300 60 # the nose\n290\t0\n";
    const Scene scene = read_scene(folder.path() / "a.toml", {{"ice.profile_file", "front.csv"}});
    CHECK(scene.ice.profile == std::vector<double>{0, 0, 0, 100, 280, 100, 300, 60, 290, 0});
    CHECK(scene.ice.profile_file.empty());
    std::ofstream(folder.path() / "front.csv") << "0, 0\n0 1 2\n";
    CHECK_THROWS_WITH_AS(read_scene(folder.path() / "a.toml", {{"ice.profile_file", "front.csv"}}),
                         doctest::Contains("front.csv:2: \"0 1 2\" is not two numbers"), SceneError);
    CHECK_THROWS_WITH_AS(read_scene(folder.path() / "a.toml", {{"ice.profile_file", "none.csv"}}),
                         doctest::Contains("none.csv"), SceneError);
}

TEST_CASE("floating ice lies where it displaces its weight") {
    const Scene box = read_text_as_scene(glacier_scene, {"ice.base=floating", "ice.size=[300, 50]"});
    CHECK(box.ice.corner.back() == doctest::Approx(50.0 - 0.9 * 50.0));
    CHECK(read_text_as_scene(resolved_text(box)).ice.corner == box.ice.corner);
    // a wedge that is as deep as it is wide: the share s of its area lies below √s of its height from the tip
    const Scene wedge = read_text_as_scene(
        without_box(), {"ice.base=floating", "ice.profile=[100, 60, 140, 60, 120, 20]", "ice.density=810"});
    CHECK(50.0 - wedge.ice.corner.back() == doctest::Approx(0.9 * 40.0));
    tells({"ice.base=floating"}, "40 m below the tank's bottom");
}

TEST_CASE("elevation models are named from the scene's folder, and what they hold is part of the scene") {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "a.toml") << glacier_scene;
    std::ofstream(folder.path() / "bed.asc") << "1";
    const std::vector<Override> sets{{"effects", "[\"water\", \"ice\", \"bed\", \"dem\"]"},
                                     {"dem.bed", "bed.asc"},
                                     {"dem.origin", "[1, 2]"},
                                     {"ice.base", "bed"}};
    const Scene scene = read_scene(folder.path() / "a.toml", sets);
    CHECK(scene.dem.bed == (folder.path() / "bed.asc").string());
    const std::string part = stage_part(scene, Stage::geometry);
    CHECK(part.find("dem.bed = \"bed.asc\"  # holds ") != std::string::npos);
    std::ofstream(folder.path() / "bed.asc") << "2";
    CHECK(stage_part(scene, Stage::geometry) != part);
    std::vector<Override> cliff = sets;
    cliff[0].value = "[\"water\", \"ice\", \"bed\", \"dem\", \"cliff\"]";
    cliff.insert(cliff.end(), {{"cliff.amplitude", "5"}, {"dem.surface", "bed.asc"}});
    CHECK_THROWS_WITH_AS(read_scene(folder.path() / "a.toml", cliff),
                         doctest::Contains("the front is the one that dem.surface shows"), SceneError);
    std::filesystem::remove(folder.path() / "bed.asc");
    CHECK_THROWS_WITH_AS(read_scene(folder.path() / "a.toml", sets), doctest::Contains("no such file"),
                         SceneError);
}
