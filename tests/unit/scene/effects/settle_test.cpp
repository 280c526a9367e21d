#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("settling has a tolerance and an end, both above 0") {
    CHECK(set_problem("settle.tolerance=0", slab_scene) == "0 Pa is out of range; it must be above 0 Pa");
    CHECK(set_problem("settle.max_time=0", slab_scene) == "0 s is out of range; it must be above 0 s");
}
