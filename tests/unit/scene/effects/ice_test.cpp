#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

namespace {

// The same scene with the ice by an outline.
std::string without_box() {
    std::string text = glacier_scene;
    const auto size = text.find("size = [300"), simulate = text.find("[simulate]");
    return text.replace(size, simulate - size, "");
}

}  // namespace

TEST_CASE("ice lies inside the tank and on the shelf, not in it") {
    CHECK(set_problem("ice.corner=[30, 10]", slab_scene) ==
          "the ice ends outside the tank: along x at 64 m, the tank at 60 m; move ice.corner or shrink "
          "ice.size");
    CHECK(set_problem("ice.corner=[0, 9]", slab_scene)
              .starts_with("the ice reaches into the shelf: its base is at 9 m, the "
                           "shelf's top at 10 m"));
    CHECK(set_problem("ice.corner=[30, 2]", slab_scene).find("shelf") == std::string::npos);  // beyond it
}

TEST_CASE("ice that rests on a bed needs one, and floating ice needs water of a given depth") {
    tells(glacier_scene, {"ice.base=bed"}, "\"bed\" needs ground to rest on");
    tells(glacier_scene, {"ice.base=floating", "water.submergence=0.5"},
          "needs water of a given water.depth");
    tells(glacier_scene, {"ice.base=floating", "ice.density=1100"},
          "needs an ice.density below water.density");
    tells(glacier_scene, {"effects=[\"water\", \"ice\", \"bed\"]", "bed.profile=[0, 10, 400, 0]"},
          "the ground below it rises to 10 m");
}

TEST_CASE("an outline gives the box around it, and is told where it is none") {
    const Sets outline{"ice.profile=[0, 0, 0, 100, 280, 100, 300, 60, 290, 0]"};
    const Scene scene = read_text_as_scene(without_box(), outline);
    CHECK(scene.ice.corner == std::vector<double>{0, 0});
    CHECK(scene.ice.size == std::vector<double>{300, 100});
    CHECK(read_text_as_scene(resolved_text(scene)).ice.profile == scene.ice.profile);
    CHECK(resolved_text(read_text_as_scene(resolved_text(scene))) == resolved_text(scene));
    CHECK(problem(without_box(), {outline[0], "ice.size=[300, 90]"})
              .find("is not that of ice.profile, [300, 100]") != std::string::npos);
    CHECK(problem(glacier_scene, {"ice.profile=[0, 0, 100, 100, 100, 0, 0, 100]"})
              .find("crosses itself at x = 50 m") != std::string::npos);
    CHECK(problem(without_box(), {"ice.profile=[0, 0, 100, 100]"}).find("three at least") !=
          std::string::npos);
    CHECK(problem(without_box()).find("ice.size: missing") != std::string::npos);
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
    tells(glacier_scene, {"ice.base=floating"}, "40 m below the tank's bottom");
}
