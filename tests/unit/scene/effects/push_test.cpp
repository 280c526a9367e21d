#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a plane that would push ice into the right wall is warned of") {
    const auto warned = scene_warnings(read_text_as_scene(slab_scene, {"simulate.end_time=20"}));
    REQUIRE(warned.size() == 1);
    CHECK(warned[0].find("has reached the right wall") != std::string::npos);
    CHECK(scene_warnings(read_text_as_scene(slab_scene)).empty());
}
