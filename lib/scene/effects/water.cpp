#include "scene/effects/water.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<mpm::WaterScheme>{"density", "paper"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<mpm::WaterTension>{"separate", "paper"};

namespace {

constexpr std::array keys{
    Key{.name = "water.depth",
        .unit = "m",
        .member = member<&Scene::water, &Water::depth>(),
        .range = positive,
        .example = "0.5",
        .effect = "water",
        .required = true,
        .instead = "water.submergence",
        .help = "of the water at rest, above the bottom"},
    Key{.name = "water.submergence",
        .member = member<&Scene::water, &Water::submergence>(),
        .range = {.min = -1.0},
        .effect = "water",
        .help =
            "D/H, gives water.depth: still water above the ice's base over the ice's height; negative: none"},
    Key{.name = "water.length",
        .unit = "m",
        .member = member<&Scene::water, &Water::length>(),
        .range = not_negative,
        .effect = "water",
        .stages = by_geometry | by_simulate,
        .help = "of the water at the start, from the left wall; 0: the whole tank"},
    Key{.name = "water.density",
        .unit = "kg/m³",
        .member = member<&Scene::water, &Water::model, &mpm::WaterModel::density>(),
        .range = positive,
        .effect = "water",
        .stages = by_simulate,
        .help = "at rest"},
    Key{.name = "water.sound_speed",
        .unit = "m/s",
        .member = member<&Scene::water, &Water::model, &mpm::WaterModel::sound_speed>(),
        .range = positive,
        .effect = "water",
        .stages = by_simulate,
        .help = "at rest; sets the stiffness and the time step; 10 times the fastest flow or more"},
    Key{.name = "water.exponent",
        .member = member<&Scene::water, &Water::model, &mpm::WaterModel::exponent>(),
        .range = {.min = 1.0, .max = 20.0, .open = true},
        .effect = "water",
        .stages = by_simulate,
        .help = "θ of the equation of state"},
    Key{.name = "water.scheme",
        .member = member<&Scene::water, &Water::model, &mpm::WaterModel::scheme>(),
        .effect = "water",
        .stages = by_simulate,
        .help = "density: the particles' volumes stay tied to the room that they have; paper: they do not, "
                "which makes noise"},
    Key{.name = "water.tension",
        .member = member<&Scene::water, &Water::model, &mpm::WaterModel::tension>(),
        .effect = "water",
        .stages = by_simulate,
        .help = "of stretched water; separate: it opens without pulling; paper: it pulls"},
};

// The depth follows from the ice's submergence.
void derive(Reading& reading) {
    Scene& scene = reading.scene;
    const bool given = reading.places.contains("water.depth");
    if (!given) reading.unusable.insert("water.depth");  // until it is known
    if (!reading.usable({"dimension", "water.submergence", "domain.size"})) return;
    if (scene.water.submergence < 0.0) {
        if (!given && reading.places.contains("water.submergence"))
            reading.report("water.depth", "missing; add it, or a water.submergence of 0 or more");
        return;
    }
    if (!scene.has("ice")) {
        reading.report("water.submergence",
                       "is measured on ice, and effects does not name \"ice\"; use water.depth");
        return;
    }
    if (!reading.usable({"ice.size", "ice.corner"})) return;
    const double depth = scene.ice.corner.back() + scene.water.submergence * scene.ice.size.back();
    if (given && std::abs(depth - scene.water.depth) > 1e-9 * depth) {
        reading.report("water.depth", metres(scene.water.depth) + ", but water.submergence says " +
                                          metres(depth) + "; remove one of them");
    }
    if (depth > 0.0 && depth <= scene.domain.size.back()) {
        scene.water.depth = depth;
        reading.unusable.erase("water.depth");
        return;
    }
    reading.report("water.submergence",
                   "puts the still water at " + metres(depth) +
                       ", which must be above 0 m and at most the tank's height; change it, ice.corner or "
                       "domain.size");
}

void check_depth(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"water.depth"})) return;
    if (scene.water.depth > scene.domain.size.back()) {
        reading.report("water.depth", metres(scene.water.depth) + " is above the tank's top at " +
                                          metres(scene.domain.size.back()) +
                                          "; lower it or raise domain.size");
    }
    if (!bed_profile_known(reading) || !reading.usable({"water.length"})) return;
    const double length = scene.water.length > 0.0 ? scene.water.length : scene.domain.size.front();
    if (length * scene.water.depth > area_below(bed_profile(scene), length, scene.water.depth)) return;
    reading.report("water.depth", metres(scene.water.depth) +
                                      " is nowhere above the bed, so the scene has no water; raise it or "
                                      "lower bed.profile");
}

void check_length(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"water.length"})) return;
    if (scene.water.length > scene.domain.size.front()) {
        reading.report("water.length", metres(scene.water.length) + " is beyond the tank's end at " +
                                           metres(scene.domain.size.front()) +
                                           "; shorten it or lengthen domain.size");
    }
    if (scene.has("wave") && scene.water.length > 0.0 && scene.water.length < scene.domain.size.front()) {
        reading.report("water.length",
                       metres(scene.water.length) + " is not the whole tank, which a wave needs; remove it");
    }
}

void check(Reading& reading) {
    if (!reading.usable({"dimension", "domain.size"})) return;
    check_depth(reading);
    check_length(reading);
}

// The fastest water that the scene makes likely, by estimates: long waves, √(g d); water let loose as by a
// broken dam, 2 √(g d) (Ritter 1892); the blocks.
double fastest_flow(const Scene& scene) {
    const double depth = scene.water.depth + scene.wave.height;
    const bool dam = scene.water.length > 0.0 && scene.water.length < scene.domain.size.front();
    const double wave = std::sqrt(scene.domain.gravity * (dam ? 4.0 * depth : depth));
    return scene.has("rigid") ? std::max(wave, fastest_block(scene)) : wave;
}

std::string sound_speed_warning(const Scene& scene) {
    const double fastest = fastest_flow(scene);
    const double speed = scene.water.model.sound_speed;
    if (speed >= 10.0 * fastest) return {};
    return "water.sound_speed: " + number_text(speed) +
           " m/s is less than 10 times the fastest expected flow, " + number_text(short_number(fastest)) +
           " m/s, so the water will compress by more than 1 %; " + number_text(std::ceil(10.0 * fastest)) +
           " m/s would do";
}

// Particles sit in the middle of their shares of the cells, so a share is filled or not.
std::string depth_warning(const Scene& scene) {
    const double spacing = particle_spacing(scene);
    const double layers = scene.water.depth / spacing;
    if (std::abs(layers - std::round(layers)) <= tolerance) return {};
    return "water.depth: " + metres(scene.water.depth) + " is not a whole number of particle spacings of " +
           metres(short_number(spacing)) + ", so the still level is off by up to half of one; " +
           metres(short_number(std::floor(layers) * spacing)) + " and " +
           metres(short_number(std::ceil(layers) * spacing)) + " would fit";
}

std::vector<std::string> warnings(const Scene& scene) {
    return {sound_speed_warning(scene), depth_warning(scene)};
}

// The depth comes first, so that of equal edges it is the one that a message names.
std::vector<Body> bodies(const Scene& scene) {
    const std::vector<double>& tank = scene.domain.size;
    const bool whole = scene.water.length == 0.0;
    std::vector<Edge> edges{{scene.water.depth, "water.depth"}};
    if (!whole) edges.push_back({scene.water.length, "water.length"});
    for (std::size_t axis = whole ? 0 : 1; axis + 1 < tank.size(); ++axis)
        edges.push_back({tank[axis], "domain.size"});
    return {{"the water", edges}};
}

}  // namespace

constinit const Effect water_effect{
    .name = "water", .keys = keys, .derive = derive, .check = check, .warnings = warnings, .bodies = bodies};

}  // namespace tidewater::scene
