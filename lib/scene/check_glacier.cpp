// The checks of what shapes a glacier: its front, crevasses, cracks, and elevation models.
#include <algorithm>
#include <cmath>

#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr double least_cells_per_crack_cell = 2.0;

bool usable_ice(const Reading& reading) {
    return reading.usable(
               {"dimension", "effects", "domain.size", "domain.cell_size", "ice.size", "ice.corner"}) &&
           reading.scene.has("ice");
}

double front_of(const Scene& scene) { return scene.ice.corner.front() + scene.ice.size.front(); }

void check_needs(Reading& reading) {
    const Scene& scene = reading.scene;
    const struct {
        const char *effect, *needs, *why;
    } rules[] = {{"cliff", "ice", "there is no cliff"},
                 {"undercut", "ice", "there is nothing to cut into"},
                 {"undercut", "water", "no water has melted a notch"},
                 {"crevasses", "ice", "there is nothing to cut into"},
                 {"cracks", "ice", "there is nothing to crack"}};
    for (const auto& [effect, needs, why] : rules) {
        if (!scene.has(effect) || scene.has(needs)) continue;
        reading.report("effects", "names " + quoted_text(effect) + " but not " + quoted_text(needs) +
                                      ", so " + why + "; add " + quoted_text(needs) + " or remove " +
                                      quoted_text(effect));
    }
    if (scene.has("cracks") && !scene.has("fracture") && reading.usable({"cracks.cohesion"}) &&
        scene.cracks.cohesion > 0.0) {
        reading.report("cracks.cohesion",
                       "above 0 is a share of the strength of ice that can fracture; add "
                       "\"fracture\" to effects or set 0, by which cracks are empty");
    }
}

void check_base(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"ice.base"}) || scene.ice.base != IceBase::bed || scene.has("bed")) return;
    reading.report("ice.base", "\"bed\" needs ground to rest on; add \"bed\" to effects, or set \"given\"");
}

void check_cliff(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!scene.has("cliff") || !reading.usable({"cliff.amplitude"})) return;
    const double a = scene.cliff.amplitude, length = scene.ice.size.front();
    if (front_of(scene) + a > scene.domain.size.front()) {
        reading.report("cliff.amplitude", metres(a) + " moves the front at x = " + metres(front_of(scene)) +
                                              " beyond the tank's end; lower it");
    }
    if (a > 0.25 * length)
        reading.report("cliff.amplitude", metres(a) + " is more than a quarter of the ice's length of " +
                                              metres(length) + "; lower it");
    const bool flat = scene.dimension == 2;
    const double shortest =
        flat ? scene.cliff.wavelength_up : std::min(scene.cliff.wavelength, scene.cliff.wavelength_up);
    if (reading.usable({"cliff.wavelength", "cliff.wavelength_up"}) &&
        shortest < 4.0 * scene.domain.cell_size) {
        reading.report(
            flat || shortest == scene.cliff.wavelength_up ? "cliff.wavelength_up" : "cliff.wavelength",
            metres(shortest) + " is less than 4 cells of " + metres(scene.domain.cell_size) +
                ", which cannot show it; lengthen it");
    }
}

void check_undercut(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!scene.has("undercut") || !reading.usable({"undercut.depth", "undercut.height", "undercut.below"}))
        return;
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

// Two numbers, the least and the greatest.
bool check_range(Reading& reading, const char* key, const std::vector<double>& range) {
    if (!reading.usable({key})) return false;
    if (range.size() == 2 && range[0] <= range[1]) return true;
    reading.report(key, list_text(range) + " is not the least and the greatest, as in [20, 50]");
    return false;
}

void check_crevasses(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!scene.has("crevasses")) return;
    const Scene::Crevasses& crevasses = scene.crevasses;
    if (check_range(reading, "crevasses.depth", crevasses.depth) &&
        crevasses.depth[1] >= scene.ice.size.back()) {
        reading.report("crevasses.depth", metres(crevasses.depth[1]) + " cuts through the ice, " +
                                              metres(scene.ice.size.back()) + " high; lower it");
    }
    const bool opening = check_range(reading, "crevasses.opening", crevasses.opening);
    if (opening && reading.usable({"crevasses.spacing"}) && crevasses.spacing < 2.0 * crevasses.opening[1]) {
        reading.report("crevasses.spacing", metres(crevasses.spacing) +
                                                " leaves no ice between crevasses up to " +
                                                metres(crevasses.opening[1]) + " wide (crevasses.opening); " +
                                                metres(2.0 * crevasses.opening[1]) + " is the least");
    }
    if (!reading.usable({"crevasses.from", "crevasses.to"})) return;
    const double to = crevasses.to > 0.0 ? crevasses.to : front_of(scene);
    if (crevasses.from >= to) {
        reading.report("crevasses.from", metres(crevasses.from) + " is not before crevasses.to, " +
                                             metres(to) + "; exchange them");
    }
}

void check_cracks(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!scene.has("cracks") || !reading.usable({"cracks.cell_size", "cracks.width"})) return;
    const double r = scene.cracks.cell_size, least = least_cells_per_crack_cell * scene.domain.cell_size;
    if (r < least) {
        reading.report("cracks.cell_size", metres(r) + " is less than 2 grid cells of " +
                                               metres(scene.domain.cell_size) +
                                               ", which cannot tell the cracks apart; " + metres(least) +
                                               " is the least, or use a smaller domain.cell_size");
    }
    if (scene.cracks.width >= 0.5 * r) {
        reading.report("cracks.width", metres(scene.cracks.width) + " leaves little of cells of " +
                                           metres(r) + " (cracks.cell_size); it must be below half of that");
    }
}

void check_dem(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!scene.has("dem")) return;
    if (reading.usable({"dem.bed", "dem.surface"}) && scene.dem.bed.empty() && scene.dem.surface.empty())
        reading.report("dem.bed", "missing, and so is dem.surface; add one, or remove \"dem\" from effects");
    if (reading.usable({"dem.origin"}) && scene.dem.origin.size() != 2)
        reading.report("dem.origin",
                       list_text(scene.dem.origin) + " is not (east, north), as in [500000, 7700000]");
    const auto needs = [&](const char* key, const std::string& file, const char* effect) {
        if (file.empty() || scene.has(effect)) return;
        reading.report(key, std::string("needs the effect ") + quoted_text(effect) + "; add it to effects");
    };
    needs("dem.bed", scene.dem.bed, "bed");
    needs("dem.surface", scene.dem.surface, "ice");
    if (!scene.dem.bed.empty() && !scene.bed.profile.empty())
        reading.report("dem.bed", "the scene has bed.profile as well; remove one of them");
    for (const char* effect : {"cliff", "undercut"}) {
        if (scene.dem.surface.empty() || !scene.has(effect)) continue;
        reading.report("effects", "names " + quoted_text(effect) +
                                      ", but the front is the one that dem.surface shows; "
                                      "remove " +
                                      quoted_text(effect) + ", or give the ice by ice.profile");
    }
    if (!scene.dem.surface.empty() && !scene.ice.profile.empty())
        reading.report("dem.surface", "the scene has ice.profile as well; remove one of them");
}

// What the grid or the particles make of it.
std::string crevasse_warning(const Scene& scene) {
    if (!scene.has("crevasses") || scene.crevasses.opening[0] >= scene.domain.cell_size) return {};
    return "crevasses.opening: from " + metres(scene.crevasses.opening[0]) + " on, narrower than a cell of " +
           metres(scene.domain.cell_size) + ", across which ice still feels ice; smaller cells part them";
}

std::string crack_warning(const Scene& scene) {
    const double spacing = scene.domain.cell_size / scene.particles.per_axis;
    if (!scene.has("cracks") || scene.cracks.width >= spacing) return {};
    const std::string width = "cracks.width: " + metres(scene.cracks.width) +
                              " is less than the particles' spacing of " + metres(short_number(spacing));
    if (scene.cracks.cohesion > 0.0) return width + "; a layer as thick as that is weakened instead";
    return width +
           "; that volume is left out, particle by particle, and the rest of a layer as thick as a spacing "
           "has failed at the start";
}

}  // namespace

void check_glacier(Reading& reading) {
    if (!reading.usable({"effects"})) return;
    check_needs(reading);
    check_dem(reading);
    if (!usable_ice(reading)) return;
    check_base(reading);
    check_cliff(reading);
    check_undercut(reading);
    check_crevasses(reading);
    check_cracks(reading);
}

std::vector<std::string> glacier_warnings(const Scene& scene) {
    return {crevasse_warning(scene), crack_warning(scene)};
}

}  // namespace tidewater::scene
