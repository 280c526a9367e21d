#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a cliff moves the front of ice within the tank, by less than a quarter of the ice") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"cliff\"]";
    CHECK(problem(glacier_scene, {effects, "cliff.amplitude=10"}) == "");
    tells(glacier_scene, {effects, "cliff.amplitude=90"}, "more than a quarter of the ice's length of 300 m");
    tells(glacier_scene, {effects, "cliff.amplitude=210"}, "beyond the tank's end");
    tells(glacier_scene, {"effects=[\"water\", \"cliff\"]", "cliff.amplitude=9"}, "there is no cliff");
}

TEST_CASE("the noise of a cliff is longer than cells can hide") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"cliff\"]";
    tells(glacier_scene, {effects, "cliff.amplitude=9", "cliff.wavelength_up=5"},
          "less than 4 cells of 2.5 m");
}
