#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a notch is cut into the front of ice, where water melts it") {
    const std::string effects = "effects=[\"water\", \"ice\", \"fracture\", \"undercut\"]";
    CHECK(problem(glacier_scene, {effects, "undercut.depth=10", "undercut.height=20"}) == "");
    tells(glacier_scene, {effects, "undercut.depth=200", "undercut.height=20"},
          "more than half of the ice's");
    tells(glacier_scene, {effects, "undercut.depth=10", "undercut.height=20", "undercut.below=60"},
          "between z = -30 m and -10 m, where the ice, from 0 m to 100 m, is not");
    tells(glacier_scene, {"effects=[\"water\", \"undercut\"]", "undercut.depth=10", "undercut.height=20"},
          "there is nothing to cut into");
    tells(glacier_scene, {"effects=[\"ice\", \"undercut\"]", "undercut.depth=10", "undercut.height=20"},
          "no water has melted a notch");
}
