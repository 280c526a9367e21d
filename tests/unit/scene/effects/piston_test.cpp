#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a piston's motion needs its own keys and no others") {
    CHECK(problem(flume_scene) == "");
    tells(flume_scene, {"piston.height=0"}, "missing; motion = \"solitary\" needs it");
    tells(flume_scene, {"piston.height=0.8"}, "above which solitary waves break");
    tells(flume_scene, {"piston.amplitude=0.1"}, "is not read with motion = \"solitary\"");
    tells(flume_scene, {"piston.motion=sine"}, "is not read with motion = \"sine\"");
    const Sets sine{"piston.motion=sine", "piston.height=0", "piston.amplitude=0.1"};
    tells(flume_scene, sine, "missing; motion = \"sine\" needs it");
    Sets complete = sine;
    complete.push_back("piston.period=2");
    CHECK(problem(flume_scene, complete) == "");
}

TEST_CASE("a piston needs water and the left wall's place") {
    tells(flume_scene, {"effects=[\"bed\", \"piston\"]"}, "so there is nothing to make waves in");
    tells(flume_scene, {"effects=[\"water\", \"piston\", \"push\"]", "push.speed=1"},
          "both take the left wall's place");
}
