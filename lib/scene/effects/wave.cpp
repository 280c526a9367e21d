#include "scene/effects/wave.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<analysis::WaveKind>{"standing", "solitary"};

namespace {

constexpr double highest_standing = 0.5;  // of the water's depth, up to which the theory holds

constexpr std::array keys{
    Key{.name = "wave.kind",
        .member = member<&Scene::wave, &Wave::kind>(),
        .effect = "wave",
        .stages = by_geometry | by_simulate,
        .help = "standing: a crest at x = 0, at rest; solitary: one crest that runs towards +x"},
    Key{.name = "wave.height",
        .unit = "m",
        .member = member<&Scene::wave, &Wave::height>(),
        .range = positive,
        .example = "0.05",
        .effect = "wave",
        .required = true,
        .stages = by_geometry | by_simulate,
        .help = "of the crest above the still water"},
    Key{.name = "wave.length",
        .unit = "m",
        .member = member<&Scene::wave, &Wave::length>(),
        .range = not_negative,
        .example = "4",
        .effect = "wave",
        .stages = by_geometry | by_simulate,
        .help = "of a standing wave; the tank holds a whole number of halves"},
    Key{.name = "wave.center",
        .unit = "m",
        .member = member<&Scene::wave, &Wave::center>(),
        .range = not_negative,
        .example = "8",
        .effect = "wave",
        .stages = by_geometry | by_simulate,
        .help = "x of a solitary wave's crest at the start"},
};

void check_height(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"water.depth"})) return;
    const double crest = scene.water.depth + scene.wave.height, top = scene.domain.size.back();
    if (crest > top) {
        reading.report("wave.height", "the crest at " + metres(short_number(crest)) +
                                          " is above the tank's top at " + metres(top) +
                                          "; lower it or raise domain.size");
    }
    const bool solitary = scene.wave.kind == analysis::WaveKind::solitary;
    const double share = solitary ? analysis::highest_solitary : highest_standing;
    if (scene.wave.height <= share * scene.water.depth * (1.0 + 1e-9)) return;
    reading.report("wave.height", metres(scene.wave.height) + " is more than " + number_text(share) +
                                      " of the water's depth, up to which the theory holds; lower it to " +
                                      metres(short_number(share * scene.water.depth)));
}

// The walls of the tank are at crests and troughs of a standing wave.
void check_length(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"wave.length"})) return;
    const double tank = scene.domain.size.front();
    if (scene.wave.length == 0.0) {
        return reading.report("wave.length", "missing; a standing wave needs its length, e.g. length = " +
                                                 number_text(2.0 * tank) + " (m)");
    }
    const double halves = 2.0 * tank / scene.wave.length;
    const double whole = std::max(std::round(halves), 1.0);
    if (std::abs(halves - whole) <= tolerance * whole) return;
    reading.report("wave.length", metres(scene.wave.length) + ": the tank of " + metres(tank) +
                                      " holds no whole number of halves of it; the nearest length is " +
                                      metres(short_number(2.0 * tank / whole)));
}

void check_center(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"wave.center"}) || scene.wave.center <= scene.domain.size.front()) return;
    reading.report("wave.center", metres(scene.wave.center) + " is beyond the tank's end at " +
                                      metres(scene.domain.size.front()) + "; move it into the tank");
}

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    for (const char* body : {"rigid", "ice", "shelf", "bed"})
        refuse_pair(reading, "wave", body, "the theories of waves assume a flat bed and open water");
    require_effect(reading, "wave", "water", "there is nothing that could make a wave");
    if (!scene.has("water") || !reading.usable({"dimension", "domain.size", "wave.kind", "wave.height"}))
        return;
    check_height(reading);
    if (scene.wave.kind == analysis::WaveKind::solitary) {
        if (scene.wave.length != 0.0)
            reading.report("wave.length", "is not read with kind = \"solitary\"; remove it");
        check_center(reading);
    } else {
        check_length(reading);
        if (scene.wave.center != 0.0)
            reading.report("wave.center", "is not read with kind = \"standing\"; remove it");
    }
    if (reading.usable({"domain.gravity"}) && scene.domain.gravity == 0.0)
        reading.report("domain.gravity", "0 m/s² makes no waves; raise it or take \"wave\" out of effects");
}

}  // namespace

analysis::InitialWave initial_wave(const Scene& scene) {
    return {.kind = scene.wave.kind,
            .height = scene.wave.height,
            .length = scene.wave.length,
            .center = scene.wave.center,
            .depth = scene.water.depth,
            .gravity = scene.domain.gravity};
}

constinit const Effect wave_effect{.name = "wave", .keys = keys, .check = check};

}  // namespace tidewater::scene
