#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

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

TEST_CASE("an elevation model needs what it describes, and takes the place of a profile") {
    const std::string effects = "effects=[\"water\", \"ice\", \"bed\", \"dem\"]";
    const Sets bed{effects, "bed.profile=[0, 0]", "dem.origin=[1, 2]"};
    tells(glacier_scene, bed, "missing, and so is dem.surface");
    tells(glacier_scene, {effects, "dem.origin=[1]", "dem.bed=bed.tif"}, "[1] is not (east, north)");
    tells(glacier_scene, {effects, "dem.origin=[1, 2]", "dem.bed=bed.tif", "bed.profile=[0, 0]"},
          "the scene has bed.profile as well");
    tells(glacier_scene, {"effects=[\"water\", \"ice\", \"dem\"]", "dem.origin=[1, 2]", "dem.bed=bed.tif"},
          "needs the effect \"bed\"; add it to effects");
}
