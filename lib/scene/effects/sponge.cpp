#include "scene/effects/sponge.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "sponge.width",
        .unit = "m",
        .member = member<&Scene::sponge, &Sponge::width>(),
        .range = positive,
        .example = "10",
        .effect = "sponge",
        .required = true,
        .stages = by_simulate,
        .help =
            "up to the right wall, in which waves are damped, ever more towards the wall, and leave their "
            "volume; 6 depths and more"},
    Key{.name = "sponge.strength",
        .member = member<&Scene::sponge, &Sponge::strength>(),
        .range = positive,
        .effect = "sponge",
        .stages = by_simulate,
        .help = "of the damping at the wall, in √(g water.depth)/width; 10 is about the best"},
};

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    require_effect(reading, "sponge", "water", "there are no waves to take");
    if (!reading.usable({"domain.size", "sponge.width"})) return;
    const double tank = scene.domain.size.front(), width = scene.sponge.width;
    if (scene.has("shelf") && reading.usable({"shelf.length"}) && tank - width < scene.shelf.length) {
        reading.report("sponge.width", metres(width) + " reaches onto the shelf, which ends at " +
                                           metres(scene.shelf.length) + "; shorten it or lengthen the tank");
    }
    if (width < tank) return;
    reading.report("sponge.width", metres(width) + " fills the tank, " + metres(tank) +
                                       " long (domain.size); shorten it or lengthen the tank");
}

}  // namespace

constinit const Effect sponge_effect{.name = "sponge", .keys = keys, .check = check};

}  // namespace tidewater::scene
