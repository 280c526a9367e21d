#include "scene/effects/cliff.h"

#include <algorithm>
#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr double cells_per_wavelength = 4.0;  // fewer cannot show it
constexpr double largest_share = 0.25;        // of the ice's length, that the front may move

constexpr std::array keys{
    Key{.name = "cliff.amplitude",
        .unit = "m",
        .member = member<&Scene::cliff, &Cliff::amplitude>(),
        .range = positive,
        .example = "10",
        .effect = "cliff",
        .required = true,
        .stages = by_geometry,
        .help = "by which the ice's front lies before and behind its place, at most; noise, fading to 0 at "
                "its rear"},
    Key{.name = "cliff.wavelength",
        .unit = "m",
        .member = member<&Scene::cliff, &Cliff::wavelength>(),
        .range = positive,
        .effect = "cliff",
        .only_3d = true,
        .stages = by_geometry,
        .help = "of that noise across the fjord, along y"},
    Key{.name = "cliff.wavelength_up",
        .unit = "m",
        .member = member<&Scene::cliff, &Cliff::wavelength_up>(),
        .range = positive,
        .effect = "cliff",
        .stages = by_geometry,
        .help = "of that noise along z"},
};

void check_amplitude(Reading& reading) {
    const Scene& scene = reading.scene;
    const double amplitude = scene.cliff.amplitude, length = scene.ice.size.front();
    if (front_of(scene) + amplitude > scene.domain.size.front()) {
        reading.report("cliff.amplitude", metres(amplitude) + " moves the front at x = " +
                                              metres(front_of(scene)) + " beyond the tank's end; lower it");
    }
    if (amplitude > largest_share * length) {
        reading.report("cliff.amplitude", metres(amplitude) +
                                              " is more than a quarter of the ice's length of " +
                                              metres(length) + "; lower it");
    }
}

void check_wavelength(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"cliff.wavelength", "cliff.wavelength_up"})) return;
    const double along = scene.cliff.wavelength, up = scene.cliff.wavelength_up;
    const double shortest = scene.dimension == 2 ? up : std::min(along, up);
    if (shortest >= cells_per_wavelength * scene.domain.cell_size) return;
    reading.report(shortest == up ? "cliff.wavelength_up" : "cliff.wavelength",
                   metres(shortest) + " is less than " + number_text(cells_per_wavelength) + " cells of " +
                       metres(scene.domain.cell_size) + ", which cannot show it; lengthen it");
}

void check(Reading& reading) {
    require_effect(reading, "cliff", "ice", "there is no cliff");
    if (!ice_box_known(reading) || !reading.usable({"cliff.amplitude"})) return;
    check_amplitude(reading);
    check_wavelength(reading);
}

}  // namespace

constinit const Effect cliff_effect{.name = "cliff", .keys = keys, .check = check};

}  // namespace tidewater::scene
