#include "scene/effects/crevasses.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "crevasses.spacing",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::spacing>(),
        .range = positive,
        .example = "100",
        .effect = "crevasses",
        .required = true,
        .stages = by_geometry,
        .help = "mean distance along x; 2.5 to 3.3 times their depth (Holdsworth 1969)"},
    Key{.name = "crevasses.depth",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::depth>(),
        .range = positive,
        .effect = "crevasses",
        .stages = by_geometry,
        .help = "the least and the greatest, below the ice's surface"},
    Key{.name = "crevasses.opening",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::opening>(),
        .range = positive,
        .effect = "crevasses",
        .stages = by_geometry,
        .help = "the least and the greatest, at the surface"},
    Key{.name = "crevasses.from",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::from>(),
        .range = not_negative,
        .effect = "crevasses",
        .stages = by_geometry,
        .help = "x at which they begin"},
    Key{.name = "crevasses.to",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::to>(),
        .range = not_negative,
        .effect = "crevasses",
        .stages = by_geometry,
        .help = "x at which they end; 0: at the front"},
    Key{.name = "crevasses.angle",
        .unit = "degrees",
        .member = member<&Scene::crevasses, &Crevasses::angle>(),
        .range = {.min = -60.0, .max = 60.0},
        .effect = "crevasses",
        .only_3d = true,
        .stages = by_geometry,
        .help = "by which they are turned from across the flow, seen from above, from y towards x"},
    Key{.name = "crevasses.length",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::length>(),
        .range = not_negative,
        .effect = "crevasses",
        .only_3d = true,
        .stages = by_geometry,
        .help = "mean, of each across the flow; 0: over the whole width"},
    Key{.name = "crevasses.wander",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::wander>(),
        .range = not_negative,
        .effect = "crevasses",
        .only_3d = true,
        .stages = by_geometry,
        .help = "by which they meander to each side"},
    Key{.name = "crevasses.wavelength",
        .unit = "m",
        .member = member<&Scene::crevasses, &Crevasses::wavelength>(),
        .range = positive,
        .effect = "crevasses",
        .only_3d = true,
        .stages = by_geometry,
        .help = "of the meanders, and of the depth and opening along them"},
};

// Whether the key's list is a minimum and a maximum; reports where it is not.
bool check_range(Reading& reading, const char* key, const std::vector<double>& range) {
    if (!reading.usable({key})) return false;
    if (range.size() == 2 && range[0] <= range[1]) return true;
    reading.report(key, list_text(range) + " is not a minimum and a maximum, as in [20, 50]");
    return false;
}

void check_sizes(Reading& reading) {
    const Scene& scene = reading.scene;
    const Crevasses& crevasses = scene.crevasses;
    if (check_range(reading, "crevasses.depth", crevasses.depth) &&
        crevasses.depth[1] >= scene.ice.size.back()) {
        reading.report("crevasses.depth", metres(crevasses.depth[1]) + " cuts through the ice, " +
                                              metres(scene.ice.size.back()) + " high; lower it");
    }
    if (!check_range(reading, "crevasses.opening", crevasses.opening)) return;
    const double widest = crevasses.opening[1];
    if (!reading.usable({"crevasses.spacing"}) || crevasses.spacing >= 2.0 * widest) return;
    reading.report("crevasses.spacing",
                   metres(crevasses.spacing) + " leaves no ice between crevasses up to " + metres(widest) +
                       " wide (crevasses.opening); use at least " + metres(2.0 * widest));
}

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    require_effect(reading, "crevasses", "ice", "there is nothing to cut into");
    if (!ice_box_known(reading)) return;
    check_sizes(reading);
    if (!reading.usable({"crevasses.from", "crevasses.to"})) return;
    const double from = scene.crevasses.from, to = scene.crevasses.to;
    if (to > 0.0 && from >= to) {
        reading.report("crevasses.from",
                       metres(from) + " is not before crevasses.to, " + metres(to) + "; exchange them");
    } else if (to == 0.0 && from >= front_of(scene)) {
        reading.report("crevasses.from", metres(from) + " is not before the ice's front at x = " +
                                             metres(front_of(scene)) + "; lower it");
    }
}

std::vector<std::string> warnings(const Scene& scene) {
    if (scene.crevasses.opening[0] >= scene.domain.cell_size) return {};
    return {"crevasses.opening: from " + metres(scene.crevasses.opening[0]) +
            " on, narrower than a cell of " + metres(scene.domain.cell_size) +
            ", across which ice still feels ice; smaller cells part them"};
}

}  // namespace

constinit const Effect crevasses_effect{
    .name = "crevasses", .keys = keys, .check = check, .warnings = warnings};

}  // namespace tidewater::scene
