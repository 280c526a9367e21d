#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("an outlet needs water and is no wider than the tank") {
    tells(slab_scene, {"outlet.width=61"}, "61 m is more than the tank, 60 m (domain.size)");
    tells(slab_scene, {"effects=[\"ice\", \"outlet\"]"}, "there is nothing to let out");
}
