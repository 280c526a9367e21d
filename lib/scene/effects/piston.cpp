#include "scene/effects/piston.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<mpm::PistonMotion>{"solitary", "sine"};

namespace {

constexpr double highest_solitary = 0.78;  // over the depth; higher solitary waves break (McCowan 1894)

constexpr std::array keys{
    Key{.name = "piston.motion",
        .member = member<&Scene::piston, &Piston::motion>(),
        .effect = "piston",
        .stages = by_simulate,
        .help = "of the left wall as a wave maker: one solitary wave (Goring 1979), or a sine"},
    Key{.name = "piston.height",
        .unit = "m",
        .member = member<&Scene::piston, &Piston::height>(),
        .range = not_negative,
        .example = "0.1",
        .effect = "piston",
        .stages = by_simulate,
        .help = "of the solitary wave above still water"},
    Key{.name = "piston.amplitude",
        .unit = "m",
        .member = member<&Scene::piston, &Piston::amplitude>(),
        .range = not_negative,
        .example = "0.05",
        .effect = "piston",
        .stages = by_simulate,
        .help = "half of the stroke of a sine, which begins at its rear end"},
    Key{.name = "piston.period",
        .unit = "s",
        .member = member<&Scene::piston, &Piston::period>(),
        .range = not_negative,
        .example = "2",
        .effect = "piston",
        .stages = by_simulate,
        .help = "of a sine"},
    Key{.name = "piston.ramp",
        .unit = "s",
        .member = member<&Scene::piston, &Piston::ramp>(),
        .range = not_negative,
        .effect = "piston",
        .stages = by_simulate,
        .help = "in which a sine grows to its amplitude"},
};

// Each motion needs its own keys, and reads no others.
void check_motion(Reading& reading) {
    const Piston& piston = reading.scene.piston;
    const struct {
        const char* key;
        double value;
        mpm::PistonMotion reader;
        const char* example;
    } keys_of_motions[] = {
        {"piston.height", piston.height, mpm::PistonMotion::solitary, "height = 0.1 (m)"},
        {"piston.amplitude", piston.amplitude, mpm::PistonMotion::sine, "amplitude = 0.05 (m)"},
        {"piston.period", piston.period, mpm::PistonMotion::sine, "period = 2 (s)"}};
    const std::string motion = piston.motion == mpm::PistonMotion::sine ? "\"sine\"" : "\"solitary\"";
    for (const auto& [key, value, reader, example] : keys_of_motions) {
        if (reader == piston.motion && value == 0.0) {
            reading.report(key, "missing; motion = " + motion + " needs it, e.g. " + example);
        } else if (reader != piston.motion && value > 0.0) {
            reading.report(key,
                           "is not read with motion = " + motion + "; remove it or change piston.motion");
        }
    }
}

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    require_effect(reading, "piston", "water", "there is nothing to make waves in");
    for (const char* other : {"push", "shelf"})
        refuse_pair(reading, "piston", other, "both take the left wall's place");
    if (!reading.usable({"piston.motion", "piston.height", "piston.amplitude", "piston.period"})) return;
    check_motion(reading);
    const double height = scene.piston.height;
    if (scene.piston.motion != mpm::PistonMotion::solitary) return;
    if (!scene.has("water") || !reading.usable({"water.depth"})) return;
    if (height <= highest_solitary * scene.water.depth) return;
    reading.report("piston.height", metres(height) + " is more than " + number_text(highest_solitary) +
                                        " of the depth of " + metres(scene.water.depth) +
                                        ", above which solitary waves break; lower it");
}

}  // namespace

constinit const Effect piston_effect{.name = "piston", .keys = keys, .check = check};

}  // namespace tidewater::scene
