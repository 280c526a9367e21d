#include "scene/effects/shelf.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/effects/effect.h"
#include "scene/ground_keys.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array shape_keys{
    Key{.name = "shelf.length",
        .unit = "m",
        .member = member<&Scene::shelf, &Shelf::length>(),
        .range = positive,
        .example = "150",
        .effect = "shelf",
        .required = true,
        .help = "from the left wall; a whole number of cells"},
    Key{.name = "shelf.height",
        .unit = "m",
        .member = member<&Scene::shelf, &Shelf::height>(),
        .range = positive,
        .example = "50",
        .effect = "shelf",
        .required = true,
        .help = "of its top above the bottom; a whole number of cells"},
    Key{.name = "shelf.holds_down",
        .member = member<&Scene::shelf, &Shelf::holds_down>(),
        .effect = "shelf",
        .stages = by_simulate,
        .help = "whether its top holds down what would lift off"},
    Key{.name = "shelf.retreat",
        .unit = "m/s",
        .member = member<&Scene::shelf, &Shelf::retreat>(),
        .range = not_negative,
        .effect = "shelf",
        .stages = by_simulate,
        .help = "speed at which its end moves back under the ice"},
};
constexpr auto keys =
    joined(shape_keys,
           ground_keys<&Scene::shelf, &Shelf::ground>(
               "shelf", {"shelf.friction", "shelf.sliding_speed", "shelf.weertman", "shelf.sliding_exponent",
                         "shelf.pore_pressure", "shelf.drag", "shelf.manning", "shelf.wall"}));

// The faces of a shelf lie on cell edges within the tank.
void check_face(Reading& reading, const char* key, double length, std::size_t axis) {
    if (!reading.usable({key})) return;
    const Scene& scene = reading.scene;
    const double cell = scene.domain.cell_size, cells = length / cell;
    if (length >= scene.domain.size[axis]) {
        reading.report(key, metres(length) + " fills the tank, " + metres(scene.domain.size[axis]) +
                                " along " + axis_name(axis, scene.dimension) +
                                "; shorten it or enlarge domain.size");
    } else if (std::abs(cells - std::round(cells)) > tolerance) {
        reading.report(key, metres(length) + " is not a whole number of cells of " + metres(cell) +
                                "; its faces lie on cell edges, the nearest is " +
                                metres(short_number(std::max(std::round(cells), 1.0) * cell)));
    }
}

void derive(Reading& reading) {
    Shelf& shelf = reading.scene.shelf;
    derive_ground(reading, "shelf", shelf.ground);
    if (shelf.ground.wall == mpm::WallRule::slip) shelf.holds_down = true;
}

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    check_ground(reading, "shelf", scene.shelf.ground);
    if (!reading.usable({"dimension", "domain.size", "domain.cell_size"})) return;
    check_face(reading, "shelf.length", scene.shelf.length, 0);
    check_face(reading, "shelf.height", scene.shelf.height, scene.domain.size.size() - 1);
}

std::vector<std::string> warnings(const Scene& scene) {
    return ground_warnings(scene, "shelf", scene.shelf.ground);
}

}  // namespace

constinit const Effect shelf_effect{
    .name = "shelf", .keys = keys, .derive = derive, .check = check, .warnings = warnings};

}  // namespace tidewater::scene
