#include "terrain.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/height_solid.h"
#include "io/elevation_file.h"
#include "io/text.h"

namespace tidewater {
namespace {

using geometry::HeightField;

std::string length(double metres) { return io::format_fixed(metres, 1) + " m"; }

HeightField read_field(const scene::Scene& scene, const std::string& file, std::string& report) {
    const auto& dem = scene.dem;
    const double spacing = scene.domain.cell_size;
    const auto nodes = [&](double extent) { return static_cast<int>(std::lround(extent / spacing)) + 1; };
    const io::ElevationMap map{
        .origin = {dem.origin[0], dem.origin[1]}, .azimuth = dem.azimuth, .datum = dem.datum, .crs = dem.crs};
    const auto grid =
        io::read_elevation(file, map, spacing, nodes(scene.domain.size[0]),
                           scene.dimension == 3 ? nodes(scene.domain.size[1]) : 1,
                           dem.nodata == scene::Nodata::fill ? io::NodataRule::fill : io::NodataRule::refuse);
    report += describe(grid.report) + "\n";
    return {.spacing = grid.spacing, .nx = grid.nx, .ny = grid.ny, .heights = grid.heights};
}

// The ground must lie in the tank; what lies above its top would be no ground there.
void check_ground(const scene::Scene& scene, const HeightField& field) {
    const double top = scene.domain.size.back();
    if (field.least() < 0.0) {
        throw InputError(scene.dem.bed + ": the ground lies down to z = " + length(field.least()) +
                         ", below the tank's bottom; lower dem.datum by " +
                         length(std::ceil(-field.least())) +
                         " or more, and with it water.depth and the ice rise");
    }
    if (field.least() >= top) {
        throw InputError(scene.dem.bed + ": the ground lies above the tank's top at " + length(top) +
                         " everywhere; raise dem.datum, or domain.size");
    }
}

// Where the model shows open water, or ice too low to be told from it, the surface drops to the tank's
// bottom.
void drop_at_water(const scene::Scene& scene, HeightField& surface) {
    const double least = scene.has("water") ? scene.water.depth + scene.dem.freeboard : 0.0;
    for (double& height : surface.heights) height = height < least ? 0.0 : height;
}

// Columns in the ice's box where its surface lies below the ground: none of them holds ice.
void check_surface(const scene::Scene& scene, const Ground& ground, const HeightField& surface,
                   std::string& report) {
    std::size_t columns = 0, inverted = 0, thin = 0;
    double worst = 0.0, worst_x = 0.0, worst_y = 0.0;
    const auto& low = scene.ice.corner;
    const auto& size = scene.ice.size;
    const bool flat = scene.dimension == 2;
    for (int i = 0; i < surface.nx; ++i) {
        for (int j = 0; j < surface.ny; ++j) {
            const double x = i * surface.spacing, y = flat ? 0.0 : j * surface.spacing;
            if (x < low[0] || x > low[0] + size[0] || (!flat && (y < low[1] || y > low[1] + size[1])))
                continue;
            if (surface.height(x, y) <= 0.0) continue;
            const double thickness = surface.height(x, y) - std::max(ground.height(x, y), low.back());
            ++columns;
            if (thickness < 0.0) ++inverted;
            if (thickness >= 0.0 && thickness < 4.0 * scene.domain.cell_size) ++thin;
            if (thickness < worst) worst = thickness, worst_x = x, worst_y = y;
        }
    }
    if (columns == 0) {
        throw InputError(scene.dem.surface +
                         ": shows no ice in the box of ice.size at ice.corner: nowhere more than " +
                         length(scene.dem.freeboard) +
                         " (dem.freeboard) above the still water; move the box, or set "
                         "dem.origin, dem.azimuth and dem.datum right");
    }
    const auto share = [&](std::size_t n) {
        return io::format_fixed(100.0 * static_cast<double>(n) / static_cast<double>(columns), 1) + " %";
    };
    const std::string place = "x = " + length(worst_x) + (flat ? "" : ", y = " + length(worst_y));
    if (inverted == columns) {
        throw InputError(scene.dem.surface +
                         ": the ice's surface lies below the ground in all of the ice's box, by " +
                         length(-worst) + " at " + place +
                         "; are dem.surface and dem.bed exchanged, or of different datums?");
    }
    if (inverted > 0) {
        report += "ice's surface: below the ground in " + share(inverted) + " of the columns, most by " +
                  length(-worst) + " at " + place + "; no ice there\n";
    }
    if (thin > 0)
        report +=
            "ice: thinner than 4 cells in " + share(thin) + " of the columns; it breaks there by itself\n";
}

// As the simulation has it: straight between the grid's node lines.
HeightField at_node_lines(const scene::Scene& scene, const geometry::Profile& profile) {
    HeightField field{.spacing = scene.domain.cell_size, .heights = {}};
    field.nx = static_cast<int>(std::lround(scene.domain.size.front() / field.spacing)) + 1;
    for (int n = 0; n < field.nx; ++n) field.heights.push_back(profile.height(n * field.spacing));
    return field;
}

}  // namespace

Terrain read_terrain(const scene::Scene& scene) {
    Terrain terrain;
    const bool dem = scene.has("dem");
    if (scene.has("bed")) {
        if (dem && !scene.dem.bed.empty()) {
            terrain.ground.field = read_field(scene, scene.dem.bed, terrain.report);
            check_ground(scene, *terrain.ground.field);
        } else {
            terrain.ground.profile = bed_profile(scene);
        }
    }
    if (dem && !scene.dem.surface.empty()) {
        terrain.surface = read_field(scene, scene.dem.surface, terrain.report);
        drop_at_water(scene, *terrain.surface);
        check_surface(scene, terrain.ground, *terrain.surface, terrain.report);
    }
    return terrain;
}

geometry::Solid ground_solid(const scene::Scene& scene, const Ground& ground) {
    if (!ground.exists()) return {};
    if (ground.profile && !ground.profile->smooth)
        return [profile = *ground.profile](const geometry::Point& p) { return signed_distance(profile, p); };
    return geometry::below(ground.field ? *ground.field : at_node_lines(scene, *ground.profile));
}

}  // namespace tidewater
