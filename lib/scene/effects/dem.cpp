#include "scene/effects/dem.h"

#include <array>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "dem.bed",
        .member = member<&Scene::dem, &Dem::bed>(),
        .example = "\"bed.tif\"",
        .effect = "dem",
        .stages = by_geometry,
        .file = true,
        .help = "elevation model of the ground, for the effect \"bed\": whatever GDAL reads, "
                "NETCDF:file:variable too"},
    Key{.name = "dem.surface",
        .member = member<&Scene::dem, &Dem::surface>(),
        .example = "\"surface.tif\"",
        .effect = "dem",
        .stages = by_geometry,
        .file = true,
        .help = "elevation model of the ice's surface; the ice is what lies below it in the box of ice.size"},
    Key{.name = "dem.origin",
        .unit = "m",
        .member = member<&Scene::dem, &Dem::origin>(),
        .example = "[500000, 7700000]",
        .effect = "dem",
        .required = true,
        .stages = by_geometry,
        .help = "map coordinates (east, north) of the scene's x = y = 0; in 2D of the line's beginning"},
    Key{.name = "dem.azimuth",
        .unit = "degrees",
        .member = member<&Scene::dem, &Dem::azimuth>(),
        .range = {.min = -360.0, .max = 360.0},
        .effect = "dem",
        .stages = by_geometry,
        .help = "direction of the scene's x, clockwise from grid north; y lies to its left"},
    Key{.name = "dem.datum",
        .unit = "m",
        .member = member<&Scene::dem, &Dem::datum>(),
        .effect = "dem",
        .stages = by_geometry,
        .help = "elevation that is z = 0: at least as low as the deepest ground"},
    Key{.name = "dem.crs",
        .member = member<&Scene::dem, &Dem::crs>(),
        .example = "\"EPSG:3413\"",
        .effect = "dem",
        .stages = by_geometry,
        .help = "of dem.origin; empty: the file's own"},
    Key{.name = "dem.freeboard",
        .unit = "m",
        .member = member<&Scene::dem, &Dem::freeboard>(),
        .range = not_negative,
        .effect = "dem",
        .stages = by_geometry,
        .help = "where dem.surface is less than this above the still water it shows water and no ice"},
    Key{.name = "dem.nodata",
        .member = member<&Scene::dem, &Dem::nodata>(),
        .effect = "dem",
        .stages = by_geometry,
        .help = "of holes: refuse them, or fill them from their rims, and say so"},
};

// The effect that an elevation model is for, and no profile beside it.
void check_use(Reading& reading, const std::string& key, const std::string& file, const std::string& effect,
               const std::vector<double>& profile) {
    if (file.empty()) return;
    if (!reading.scene.has(effect))
        reading.report(key, "needs the effect " + quoted_text(effect) + "; add it to effects");
    if (!profile.empty())
        reading.report(key, "the scene has " + effect + ".profile as well; remove one of them");
}

void check(Reading& reading) {
    const Scene& scene = reading.scene;
    if (reading.usable({"dem.bed", "dem.surface"}) && scene.dem.bed.empty() && scene.dem.surface.empty())
        reading.report("dem.bed", "missing, and so is dem.surface; add one, or remove \"dem\" from effects");
    if (reading.usable({"dem.origin"}) && scene.dem.origin.size() != 2) {
        reading.report("dem.origin",
                       list_text(scene.dem.origin) + " is not (east, north), as in [500000, 7700000]");
    }
    check_use(reading, "dem.bed", scene.dem.bed, "bed", scene.bed.profile);
    check_use(reading, "dem.surface", scene.dem.surface, "ice", scene.ice.profile);
    for (const char* effect : {"cliff", "undercut"}) {
        if (scene.dem.surface.empty() || !scene.has(effect)) continue;
        reading.report("effects", "names " + quoted_text(effect) +
                                      ", but the front is the one that dem.surface shows; remove " +
                                      quoted_text(effect) + ", or give the ice by ice.profile");
    }
}

}  // namespace

constinit const Effect dem_effect{.name = "dem", .keys = keys, .check = check};

}  // namespace tidewater::scene
