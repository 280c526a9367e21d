#include "scene/effects/outlet.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "outlet.width",
        .unit = "m",
        .member = member<&Scene::outlet, &Outlet::width>(),
        .range = positive,
        .example = "60",
        .effect = "outlet",
        .required = true,
        .stages = by_simulate,
        .help = "up to the right wall, where water above the still level leaves; about the depth: a narrow "
                "outlet lets "
                "out too little"},
};

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    require_effect(reading, "outlet", "water", "there is nothing to let out");
    if (!reading.usable({"domain.size", "outlet.width"})) return;
    if (scene.outlet.width <= scene.domain.size.front()) return;
    reading.report("outlet.width", metres(scene.outlet.width) + " is more than the tank, " +
                                       metres(scene.domain.size.front()) + " (domain.size); shorten it");
}

}  // namespace

constinit const Effect outlet_effect{.name = "outlet", .keys = keys, .check = check};

}  // namespace tidewater::scene
