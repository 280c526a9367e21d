#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("crevasses leave ice between and below them") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"crevasses\"]";
    CHECK(problem(glacier_scene, {effects, "crevasses.spacing=90"}) == "");
    tells(glacier_scene, {effects, "crevasses.spacing=15"}, "use at least 20 m");
    tells(glacier_scene, {effects, "crevasses.spacing=90", "crevasses.depth=[20, 120]"},
          "cuts through the ice, 100 m high");
    tells(glacier_scene, {"effects=[\"water\", \"crevasses\"]", "crevasses.spacing=90"},
          "there is nothing to cut into");
}

TEST_CASE("a range of crevasses is a minimum and a maximum, and their place begins before it ends") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"crevasses\"]";
    tells(glacier_scene, {effects, "crevasses.spacing=90", "crevasses.depth=[50, 20]"},
          "[50, 20] is not a minimum and a maximum");
    tells(glacier_scene, {effects, "crevasses.spacing=90", "crevasses.from=200", "crevasses.to=100"},
          "200 m is not before crevasses.to, 100 m; exchange them");
    tells(glacier_scene, {effects, "crevasses.spacing=90", "crevasses.from=300"},
          "300 m is not before the ice's front at x = 300 m; lower it");
}

TEST_CASE("crevasses narrower than a cell are warned of") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"crevasses\"]";
    const auto warned = [&](const std::string& opening) {
        const Sets sets{effects, "crevasses.spacing=90", "crevasses.opening=" + opening};
        return scene_warnings(read_text_as_scene(glacier_scene, sets)).size();
    };
    CHECK(warned("[1, 10]") == warned("[5, 10]") + 1);
}
