#include "scene/effects/bed.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/ground_keys.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array shape_keys{
    Key{.name = "bed.profile",
        .unit = "m",
        .member = member<&Scene::bed, &Bed::profile>(),
        .example = "[0, 0, 10, 1]",
        .effect = "bed",
        .help = "the ground: x0, z0, x1, z1, … of its corners, x rising; level beyond the ends; in 3D the "
                "same for "
                "all y"},
    Key{.name = "bed.profile_file",
        .member = member<&Scene::bed, &Bed::profile_file>(),
        .example = "\"fjord.csv\"",
        .effect = "bed",
        .points_of = "bed.profile",
        .changes_results = false,
        .help = "a table of x and z, two columns, from which bed.profile is read"},
    Key{.name = "bed.shape",
        .member = member<&Scene::bed, &Bed::shape>(),
        .effect = "bed",
        .help = "between corners: straight, or smooth, which is level at each corner"},
};
constexpr auto keys = joined(
    shape_keys, ground_keys<&Scene::bed, &Bed::ground>(
                    "bed", {"bed.friction", "bed.sliding_speed", "bed.weertman", "bed.sliding_exponent",
                            "bed.pore_pressure", "bed.drag", "bed.manning", "bed.wall"}));

// Then the geometry stage knows the heights, and the scene does not.
bool from_elevation_model(const Scene& scene) { return scene.has("dem") && !scene.dem.bed.empty(); }

bool is_rising(const std::vector<double>& list) {
    for (std::size_t i = 2; i < list.size(); i += 2) {
        if (list[i] <= list[i - 2]) return false;
    }
    return true;
}

// Checks bed.profile by itself.
void check_profile(Reading& reading) {
    const auto& list = reading.scene.bed.profile;
    if (list.empty()) {
        reading.report(
            "bed.profile",
            "missing; add it under [bed], e.g. profile = [0, 0, 10, 1], or name an elevation model "
            "as dem.bed");
    } else if (list.size() % 2 != 0) {
        reading.report("bed.profile", "has " + std::to_string(list.size()) +
                                          " numbers; it takes pairs x0, z0, x1, z1, …, at least one");
    }
    for (std::size_t i = 2; i < list.size(); i += 2) {
        if (list[i] > list[i - 2]) continue;
        reading.report("bed.profile",
                       "x = " + metres(list[i]) + " comes after x = " + metres(list[i - 2]) +
                           "; x must rise from corner to corner, so sort them, and make a step steep instead "
                           "of upright");
    }
}

void check_heights(Reading& reading, const geometry::Profile& profile) {
    const double top = reading.scene.domain.size.back();
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
        if (profile.z[i] >= 0.0 && profile.z[i] < top) continue;
        reading.report("bed.profile", "the corner at x = " + metres(profile.x[i]) + " lies at z = " +
                                          metres(profile.z[i]) + ", outside the tank from 0 m to " +
                                          metres(top) + "; move it or enlarge domain.size");
    }
}

// The ground lies below the top of a shelf that stands on it.
void check_shelf(Reading& reading, const geometry::Profile& profile) {
    const Scene& scene = reading.scene;
    if (!scene.has("shelf") || !reading.usable({"shelf.length", "shelf.height"})) return;
    const double ground = profile.highest(0.0, scene.shelf.length);
    if (ground <= scene.shelf.height) return;
    reading.report("bed.profile", "rises to " + metres(short_number(ground)) +
                                      " within the shelf, whose top is at " + metres(scene.shelf.height) +
                                      "; raise shelf.height or lower the bed there");
}

void derive(Reading& reading) { derive_ground(reading, "bed", reading.scene.bed.ground); }

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    check_ground(reading, "bed", scene.bed.ground);
    if (from_elevation_model(scene) || !reading.usable({"bed.profile"})) return;
    check_profile(reading);
    if (!bed_profile_known(reading) || !reading.usable({"dimension", "domain.size"})) return;
    const geometry::Profile profile = bed_profile(scene);
    check_heights(reading, profile);
    check_shelf(reading, profile);
}

std::vector<std::string> warnings(const Scene& scene) {
    return ground_warnings(scene, "bed", scene.bed.ground);
}

}  // namespace

geometry::Profile bed_profile(const Scene& scene) {
    geometry::Profile profile;
    profile.smooth = scene.bed.shape == BedShape::smooth;
    for (std::size_t i = 0; i + 1 < scene.bed.profile.size(); i += 2) {
        profile.x.push_back(scene.bed.profile[i]);
        profile.z.push_back(scene.bed.profile[i + 1]);
    }
    return profile;
}

bool bed_profile_known(const Reading& reading) {
    const auto& list = reading.scene.bed.profile;
    return reading.scene.has("bed") && !from_elevation_model(reading.scene) &&
           reading.usable({"bed.profile"}) && !list.empty() && list.size() % 2 == 0 && is_rising(list);
}

constinit const Effect bed_effect{
    .name = "bed", .keys = keys, .derive = derive, .check = check, .warnings = warnings};

}  // namespace tidewater::scene
