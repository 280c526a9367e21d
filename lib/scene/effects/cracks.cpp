#include "scene/effects/cracks.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr double min_cells = 2.0;  // of the grid, along a Voronoi cell

constexpr std::array keys{
    Key{.name = "cracks.cell_size",
        .unit = "m",
        .member = member<&Scene::cracks, &Cracks::cell_size>(),
        .range = positive,
        .example = "80",
        .effect = "cracks",
        .required = true,
        .stages = by_geometry | by_simulate,
        .help = "r of the Voronoi cells that the cracks part: one in each r² (3D: r³)"},
    Key{.name = "cracks.width",
        .unit = "m",
        .member = member<&Scene::cracks, &Cracks::width>(),
        .range = positive,
        .example = "1",
        .effect = "cracks",
        .required = true,
        .stages = by_geometry | by_simulate,
        .help = "of a crack"},
    Key{.name = "cracks.cohesion",
        .member = member<&Scene::cracks, &Cracks::cohesion>(),
        .range = {.min = 0.0, .max = 1.0},
        .effect = "cracks",
        .stages = by_geometry | by_simulate,
        .help = "share of its strength that ice in a crack has; 0: the crack is empty"},
};

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    require_effect(reading, "cracks", "ice", "there is nothing to crack");
    if (!scene.has("fracture") && reading.usable({"cracks.cohesion"}) && scene.cracks.cohesion > 0.0) {
        reading.report("cracks.cohesion",
                       "above 0 is a share of the strength of ice that can fracture; add \"fracture\" to "
                       "effects or set 0, by which cracks are empty");
    }
    if (!ice_box_known(reading) || !reading.usable({"cracks.cell_size", "cracks.width"})) return;
    const double size = scene.cracks.cell_size, min_size = min_cells * scene.domain.cell_size;
    if (size < min_size) {
        reading.report("cracks.cell_size", metres(size) + " is less than " + number_text(min_cells) +
                                               " grid cells of " + metres(scene.domain.cell_size) +
                                               ", which cannot tell the cracks apart; use at least " +
                                               metres(min_size) + " or a smaller domain.cell_size");
    }
    if (scene.cracks.width >= 0.5 * size) {
        reading.report("cracks.width", metres(scene.cracks.width) + " leaves little of cells of " +
                                           metres(size) +
                                           " (cracks.cell_size); it must be below half of that");
    }
}

std::vector<std::string> warnings(const Scene& scene) {
    const double spacing = particle_spacing(scene);
    if (scene.cracks.width >= spacing) return {};
    const std::string width = "cracks.width: " + metres(scene.cracks.width) +
                              " is less than the particles' spacing of " + metres(short_number(spacing));
    if (scene.cracks.cohesion > 0.0) return {width + "; a layer as thick as that is weakened instead"};
    return {width +
            "; that volume is left out, particle by particle, and the rest of a layer as thick as a spacing "
            "has failed at the start"};
}

}  // namespace

constinit const Effect cracks_effect{.name = "cracks", .keys = keys, .check = check, .warnings = warnings};

}  // namespace tidewater::scene
