#include "scene/ground_keys.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

namespace {

// Ice and water on a bed and a shelf.
const std::string shelf_scene = R"(effects = ["water", "ice", "bed", "shelf"]
[domain]
size = [20, 4]
cell_size = 0.1
[water]
depth = 1
[ice]
size = [2, 1]
corner = [0, 0.6]
[bed]
profile = [8, 0, 10, 0.5]
[shelf]
length = 2
height = 0.6
[simulate]
end_time = 3
snapshot_interval = 0.5
)";

std::vector<std::string> warned(const Sets& sets) {
    return scene_warnings(read_text_as_scene(shelf_scene, sets));
}

bool any_holds(const std::vector<std::string>& lines, const std::string& part) {
    return std::ranges::any_of(lines, [&](const auto& line) { return line.find(part) != line.npos; });
}

}  // namespace

TEST_CASE("friction and drag take inf, and no other key does") {
    CHECK(std::isinf(read_text_as_scene(flume_scene, {"bed.friction=inf"}).bed.ground.friction));
    CHECK(std::isinf(read_text_as_scene(flume_scene, {"bed.drag=inf"}).bed.ground.drag));
    tells(flume_scene, {"bed.friction=-inf"},
          "is out of range; it must be a finite number at least 0, or inf");
    tells(flume_scene, {"bed.friction=nan"}, "is out of range");
    tells(flume_scene, {"bed.manning=inf"}, "is out of range");
    const Scene scene = read_text_as_scene(flume_scene, {"bed.friction=inf"});
    CHECK(resolved_text(scene).find("friction = inf ") != std::string::npos);
    CHECK(resolved_text(read_text_as_scene(resolved_text(scene))) == resolved_text(scene));
}

TEST_CASE("a retired wall still runs as what it is to be written as, and a line says how") {
    const auto rule = [](const std::string& wall) {
        return read_text_as_scene(flume_scene, {"bed.wall=" + wall}).bed.ground.friction;
    };
    CHECK(std::isinf(rule("stick")));
    CHECK(rule("slip") == 0.0);
    CHECK(rule("separate") == 0.0);
    CHECK(any_holds(warned({"bed.wall=stick"}),
                    "bed.wall is no longer a key: in place of \"stick\" write bed.friction = inf"));
    CHECK(any_holds(warned({"bed.wall=slip"}), "in place of \"slip\" write nothing"));
    tells(flume_scene, {"bed.wall=stick", "bed.friction=0.5"}, "remove bed.wall");
    const std::string resolved = resolved_text(read_text_as_scene(flume_scene, {"bed.wall=stick"}));
    CHECK(resolved.find("wall = \"stick\"") == std::string::npos);
    CHECK(resolved.find("friction = inf") != std::string::npos);
    CHECK(read_text_as_scene(shelf_scene, {"shelf.wall=slip"}).shelf.holds_down);
    CHECK(any_holds(warned({"shelf.wall=slip"}), "write shelf.holds_down = true"));
}

TEST_CASE("a ground takes one law of drag, and what friction alone reads needs friction") {
    tells(flume_scene, {"bed.drag=0.003", "bed.manning=0.02"},
          "is another law of the same drag than bed.drag; remove one of them");
    tells(flume_scene, {"bed.pore_pressure=1"}, "is not read without bed.friction; add it or remove");
    tells(flume_scene, {"bed.sliding_speed=300"}, "is not read without bed.friction; add it or remove");
    CHECK(problem(flume_scene, {"bed.friction=0.5", "bed.pore_pressure=1", "bed.manning=0.02"}) == "");
}

TEST_CASE("held water is warned of with the thickness of its layer against the depth") {
    const std::size_t before = warned({"bed.friction=0.5", "bed.drag=0.003"}).size();
    for (const char* set : {"bed.drag=inf", "domain.wall_bottom=stick"}) {
        CAPTURE(set);
        const auto lines = warned({set});
        CHECK(lines.size() == before + 1);
        CHECK(any_holds(lines, "holds the water, in a layer that grows with each step: about "));
    }
    // 0.024 n = 256, δ = 4 cells.
    Scene scene = read_text_as_scene(flume_scene, {"water.sound_speed=20"});
    scene.simulate.end_time = 256.0 / 0.024 * scene.simulate.cfl * scene.domain.cell_size / 20.0;
    CHECK(held_layer(scene, "x").find("about " + std::string("0.4 m thick after 11000 steps")) !=
          std::string::npos);
}

TEST_CASE("ground that rubs in a scene without ice is warned of") {
    CHECK(any_holds(scene_warnings(read_text_as_scene(flume_scene, {"bed.friction=0.5"})),
                    "bed.friction: acts on ice, of which the scene has none"));
}
