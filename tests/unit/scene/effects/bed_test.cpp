#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a bed's profile is pairs with rising x inside the tank") {
    CHECK(problem(flume_scene) == "");
    tells(flume_scene, {"bed.profile=[]"}, "missing; add it under [bed]");
    tells(flume_scene, {"bed.profile=[1, 0, 2]"}, "has 3 numbers; it takes pairs");
    tells(flume_scene, {"bed.profile=[4, 0, 4, 1]"}, "x must rise from corner to corner");
    tells(flume_scene, {"bed.profile=[4, 0, 5, 2]"}, "outside the tank from 0 m to 2 m");
    tells(flume_scene, {"bed.profile=[4, -0.1]"}, "outside the tank from 0 m to 2 m");
}

TEST_CASE("a bed lies below the shelf on it") {
    tells(flume_scene, {"effects=[\"water\", \"bed\", \"shelf\"]", "shelf.length=12", "shelf.height=0.4"},
          "rises to 0.5 m within the shelf");
}
