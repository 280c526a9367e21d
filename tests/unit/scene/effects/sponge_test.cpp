#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a sponge needs water, and leaves a part of the tank for it") {
    CHECK(problem(flume_scene) == "");
    tells(flume_scene, {"sponge.width=20"}, "20 m fills the tank, 20 m long");
    tells(flume_scene, {"effects=[\"bed\", \"sponge\"]"}, "so there are no waves to take");
}

TEST_CASE("a sponge ends before the shelf") {
    tells(flume_scene, {"effects=[\"water\", \"sponge\", \"shelf\"]", "shelf.length=15", "shelf.height=0.5"},
          "reaches onto the shelf");
}
