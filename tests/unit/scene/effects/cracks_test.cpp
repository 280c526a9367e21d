#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("cracks part cells that the grid can tell apart") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"cracks\"]";
    CHECK(problem(glacier_scene, {effects, "cracks.cell_size=40", "cracks.width=1", "cracks.cohesion=0.3"}) ==
          "");
    tells(glacier_scene, {effects, "cracks.cell_size=4", "cracks.width=1"},
          "less than 2 grid cells of 2.5 m");
    tells(glacier_scene, {effects, "cracks.cell_size=40", "cracks.width=25"}, "must be below half of that");
}

TEST_CASE("cracks need ice, and their cohesion ice that can fracture") {
    const Sets cracks{"cracks.cell_size=40", "cracks.width=1", "cracks.cohesion=0.3"};
    Sets elastic = cracks, none = cracks;
    elastic.push_back("effects=[\"water\", \"ice\", \"cracks\"]");
    none.push_back("effects=[\"water\", \"cracks\"]");
    tells(glacier_scene, elastic, "add \"fracture\" to effects or set 0");
    tells(glacier_scene, none, "there is nothing to crack");
}

TEST_CASE("cracks thinner than the particles' spacing are warned of") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"cracks\"]";
    const auto warned = [&](const std::string& width) {
        const Sets sets{effects, "cracks.cell_size=40", "cracks.width=" + width};
        return scene_warnings(read_text_as_scene(glacier_scene, sets)).size();
    };
    CHECK(warned("1") == warned("2") + 1);
}
