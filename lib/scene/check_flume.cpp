// The checks of what a flume has: its bed, its wave maker and its sponge.
#include <algorithm>

#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

// Of bed.profile alone. False if it cannot be used.
bool check_profile(Reading& reading) {
    const auto& list = reading.scene.bed.profile;
    const auto report = [&](const std::string& problem) { reading.report("bed.profile", problem); };
    const std::size_t before = reading.problems.size();
    if (list.empty()) {
        report(
            "missing; add it under [bed], e.g. profile = [0, 0, 10, 1], or name an elevation model as "
            "dem.bed");
    } else if (list.size() % 2 != 0) {
        report("has " + std::to_string(list.size()) +
               " numbers; it takes pairs x0, z0, x1, z1, …, at least one");
    }
    for (std::size_t i = 2; i < list.size(); i += 2) {
        if (list[i] > list[i - 2]) continue;
        report("x = " + metres(list[i]) + " comes after x = " + metres(list[i - 2]) +
               "; x must rise from corner to corner, so sort them, and make a step steep instead of upright");
    }
    return reading.problems.size() == before;
}

// The ground lies in the tank and below what stands on it.
void check_heights(Reading& reading) {
    const Scene& scene = reading.scene;
    const geometry::Profile profile = bed_profile(scene);
    const double top = scene.domain.size.back();
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
        if (profile.z[i] >= 0.0 && profile.z[i] < top) continue;
        reading.report("bed.profile", "the corner at x = " + metres(profile.x[i]) + " lies at z = " +
                                          metres(profile.z[i]) + ", outside the tank from 0 m to " +
                                          metres(top) + "; move it or enlarge domain.size");
    }
    if (scene.has("shelf") && reading.usable({"shelf.length", "shelf.height"})) {
        const double ground = profile.highest(0.0, scene.shelf.length);
        if (ground > scene.shelf.height) {
            reading.report("bed.profile", "rises to " + metres(short_number(ground)) +
                                              " within the shelf, whose top is at " +
                                              metres(scene.shelf.height) +
                                              "; raise shelf.height or lower the bed there");
        }
    }
    if (!scene.has("ice") || !reading.usable({"ice.size", "ice.corner", "ice.base"})) return;
    if (scene.ice.base == IceBase::bed || !scene.dem.surface.empty() || !scene.ice.profile.empty()) return;
    const double end = scene.ice.corner.front() + scene.ice.size.front();
    const double ground = profile.highest(scene.ice.corner.front(), end);
    if (scene.ice.corner.back() >= ground - 1e-6 * scene.domain.cell_size) return;
    reading.report("ice.corner", "the ice reaches into the bed: its base is at " +
                                     metres(scene.ice.corner.back()) + ", the ground below it rises to " +
                                     metres(short_number(ground)) +
                                     "; raise the ice, lower bed.profile, or set ice.base = \"bed\"");
}

}  // namespace

void check_bed(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects"}) || !scene.has("bed")) return;
    if (scene.has("dem") && !scene.dem.bed.empty()) return;  // the geometry stage knows its heights
    if (!reading.usable({"bed.profile"}) || !check_profile(reading)) return;
    if (reading.usable({"dimension", "domain.size", "domain.cell_size"})) check_heights(reading);
    if (!scene.has("water") || !reading.usable({"domain.size", "water.depth", "water.length"})) return;
    const geometry::Profile profile = bed_profile(scene);
    const double length = scene.water.length > 0.0 ? scene.water.length : scene.domain.size.front();
    if (length * scene.water.depth > area_below(profile, length, scene.water.depth)) return;
    reading.report("water.depth", metres(scene.water.depth) +
                                      " is nowhere above the bed, so there is no "
                                      "water; raise it or lower bed.profile");
}

// Each motion has its own keys.
void check_piston(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects"}) || !scene.has("piston")) return;
    for (const char* other : {"push", "shelf"}) {
        if (!scene.has(other)) continue;
        reading.report("effects", std::string("names \"piston\" and ") + quoted_text(other) +
                                      ": both take the left wall's place; remove one of them");
    }
    if (!reading.usable({"piston.motion", "piston.height", "piston.amplitude", "piston.period"})) return;
    const auto& piston = scene.piston;
    const bool sine = piston.motion == mpm::PistonMotion::sine;
    const struct {
        const char* key;
        double value;
        bool sine;
        const char* example;
    } keys[] = {{"piston.height", piston.height, false, "height = 0.1 (m)"},
                {"piston.amplitude", piston.amplitude, true, "amplitude = 0.05 (m)"},
                {"piston.period", piston.period, true, "period = 2 (s)"}};
    for (const auto& [key, value, of_sine, example] : keys) {
        const std::string motion = std::string("motion = ") + (sine ? "\"sine\"" : "\"solitary\"");
        if (of_sine == sine && value == 0.0) {
            reading.report(key, "missing; " + motion + " needs it, e.g. " + example);
        } else if (of_sine != sine && value > 0.0) {
            reading.report(key, "is not read with " + motion + "; remove it or change piston.motion");
        }
    }
    // Higher solitary waves break (McCowan 1894).
    if (sine || !reading.usable({"water.depth"}) || piston.height <= 0.78 * scene.water.depth) return;
    reading.report("piston.height", metres(piston.height) + " is more than 0.78 of the depth of " +
                                        metres(scene.water.depth) +
                                        ", above which solitary waves break; lower it");
}

void check_sponge(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects", "domain.size", "sponge.width"}) || !scene.has("sponge")) return;
    const double from = scene.domain.size.front() - scene.sponge.width;
    if (scene.has("shelf") && reading.usable({"shelf.length"}) && from < scene.shelf.length) {
        reading.report("sponge.width", metres(scene.sponge.width) +
                                           " reaches onto the shelf, which ends at " +
                                           metres(scene.shelf.length) + "; shorten it or lengthen the tank");
    }
    if (scene.sponge.width < scene.domain.size.front()) return;
    reading.report("sponge.width", metres(scene.sponge.width) + " fills the tank, " +
                                       metres(scene.domain.size.front()) +
                                       " long (domain.size); shorten it or lengthen the tank");
}

}  // namespace tidewater::scene
