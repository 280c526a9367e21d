// The keys of the whole scene and of its tank.
#include <array>

#include "scene/keys_parts.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "title",
        .member = member<&Scene::title>(),
        .example = "\"A block falls into the tank\"",
        .stages = by_postprocess,
        .help = "one line for pictures and reports"},
    Key{.name = "dimension",
        .member = member<&Scene::dimension>(),
        .range = {.min = 2, .max = 3},
        .help = "2: a vertical slice (x, z); 3: (x, y, z)"},
    Key{.name = "effects",
        .member = member<&Scene::effects>(),
        .example = "[\"water\", \"rigid\"]",
        .required = true,
        .help = "the physics that is simulated"},
    Key{.name = "seed",
        .member = member<&Scene::seed>(),
        .stages = by_geometry | by_simulate,
        .help = "of all random numbers; the same seed gives the same bytes"},

    Key{.name = "domain.size",
        .unit = "m",
        .member = member<&Scene::domain, &Scene::Domain::size>(),
        .range = positive,
        .example = "[16, 1]",
        .required = true,
        .per_dimension = true,
        .help = "the tank is the box from the origin to size; a whole number of cells"},
    Key{.name = "domain.cell_size",
        .unit = "m",
        .member = member<&Scene::domain, &Scene::Domain::cell_size>(),
        .range = positive,
        .example = "0.01",
        .required = true,
        .help = "width Δx of a grid cell; 40 to 50 per smallest length give good waves"},
    Key{.name = "domain.gravity",
        .unit = "m/s²",
        .member = member<&Scene::domain, &Scene::Domain::gravity>(),
        .range = not_negative,
        .stages = by_simulate | by_postprocess,
        .help = "downward"},
    Key{.name = "domain.wall_left",
        .member = member<&Scene::domain, &Scene::Domain::wall_left>(),
        .stages = by_simulate,
        .help = "what the wall at x = 0 does to what touches it"},
    Key{.name = "domain.wall_right",
        .member = member<&Scene::domain, &Scene::Domain::wall_right>(),
        .stages = by_simulate,
        .help = "at the greatest x"},
    Key{.name = "domain.wall_front",
        .member = member<&Scene::domain, &Scene::Domain::wall_front>(),
        .only_3d = true,
        .stages = by_simulate,
        .help = "at y = 0"},
    Key{.name = "domain.wall_back",
        .member = member<&Scene::domain, &Scene::Domain::wall_back>(),
        .only_3d = true,
        .stages = by_simulate,
        .help = "at the greatest y"},
    Key{.name = "domain.wall_bottom",
        .member = member<&Scene::domain, &Scene::Domain::wall_bottom>(),
        .stages = by_simulate,
        .help = "at z = 0"},
    Key{.name = "domain.wall_top",
        .member = member<&Scene::domain, &Scene::Domain::wall_top>(),
        .stages = by_simulate,
        .help = "at the greatest z"},
};

}  // namespace

std::span<const Key> scene_keys() { return keys; }

}  // namespace tidewater::scene
