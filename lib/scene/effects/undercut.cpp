#include "scene/effects/undercut.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "undercut.depth",
        .unit = "m",
        .member = member<&Scene::undercut, &Undercut::depth>(),
        .range = positive,
        .example = "15",
        .effect = "undercut",
        .required = true,
        .stages = by_geometry,
        .help = "of the notch that melt has cut into the front: half an ellipse"},
    Key{.name = "undercut.height",
        .unit = "m",
        .member = member<&Scene::undercut, &Undercut::height>(),
        .range = positive,
        .example = "40",
        .effect = "undercut",
        .required = true,
        .stages = by_geometry,
        .help = "of the notch"},
    Key{.name = "undercut.below",
        .unit = "m",
        .member = member<&Scene::undercut, &Undercut::below>(),
        .effect = "undercut",
        .stages = by_geometry,
        .help = "how far its upper edge lies below the still water; negative: above"},
};

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    require_effect(reading, "undercut", "ice", "there is nothing to cut into");
    require_effect(reading, "undercut", "water", "no water has melted a notch");
    if (!ice_box_known(reading)) return;
    if (!reading.usable({"undercut.depth", "undercut.height", "undercut.below"})) return;
    if (scene.undercut.depth > 0.5 * scene.ice.size.front()) {
        reading.report("undercut.depth", metres(scene.undercut.depth) +
                                             " is more than half of the ice's length of " +
                                             metres(scene.ice.size.front()) + "; lower it");
    }
    if (!scene.has("water") || !reading.usable({"water.depth"})) return;
    const double top = scene.water.depth - scene.undercut.below, bottom = top - scene.undercut.height;
    const double base = scene.ice.corner.back(), surface = base + scene.ice.size.back();
    if (bottom < surface && top > base) return;
    reading.report("undercut.below", "puts the notch between z = " + metres(short_number(bottom)) + " and " +
                                         metres(short_number(top)) + ", where the ice, from " + metres(base) +
                                         " to " + metres(surface) + ", is not; change it or water.depth");
}

}  // namespace

constinit const Effect undercut_effect{.name = "undercut", .keys = keys, .check = check};

}  // namespace tidewater::scene
