#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a shelf's faces lie on cell edges inside the tank") {
    CHECK(set_problem("shelf.length=29.5", slab_scene) ==
          "29.5 m is not a whole number of cells of 1 m; its faces lie on cell "
          "edges, the nearest is 30 m");
    CHECK(set_problem("shelf.length=60", slab_scene) ==
          "60 m fills the tank, 60 m along x; shorten it or enlarge domain.size");
}
