#include "show.h"

#include <algorithm>
#include <cmath>

#include "common/tank.h"
#include "io/level_set_files.h"
#include "io/section_picture.h"
#include "io/text.h"

namespace tidewater {
namespace {

constexpr double most_values = 50e6;  // of distances in the image; of more voxels it has the materials alone

// What is shown of a grid: nothing of the tank, of heights, and of ice that is there to be seeded.
std::uint8_t number_of(const std::string& name) {
    if (name == "bed") return 1;
    if (name == "water") return 2;
    if (name == "ice") return 3;
    if (name == "shelf") return 4;
    return name.starts_with("block") ? 5 : 0;
}

// What is at a place, of the exact bodies: cracks thinner than a voxel show.
io::Substance substance_at(const Bodies& bodies, const geometry::Point& at) {
    for (const BoxBody& body : bodies.boxes) {
        if (signed_distance(body.box, at) > 0.0) continue;
        return body.block == nullptr ? io::Substance::ground : io::Substance::block;
    }
    if (bodies.ground && bodies.ground(at) <= 0.0) return io::Substance::ground;
    if (bodies.ice && bodies.ice->shown(at) <= 0.0) return io::Substance::ice;
    return bodies.water && bodies.water(at) <= 0.0 ? io::Substance::water : io::Substance::nothing;
}

double ground_height(const scene::Scene& scene, const Bodies& bodies, double x, double y) {
    const double bed = bodies.terrain.ground.height(x, y);
    return scene.has("shelf") && x <= scene.shelf.length ? std::max(bed, scene.shelf.height) : bed;
}

// The uppermost that is met on the way down, in steps of half a cell, then by bisection.
io::Top top_at(const scene::Scene& scene, const Bodies& bodies, double x, double y) {
    const double step = 0.5 * scene.domain.cell_size;
    io::Top top{.bed = ground_height(scene, bodies, x, y)};
    double z = scene.domain.size.back();
    while (z > 0.0 && substance_at(bodies, {x, y, z}) == io::Substance::nothing) z -= step;
    top.substance = substance_at(bodies, {x, y, std::max(z, 0.0)});
    if (top.substance == io::Substance::nothing) top.substance = io::Substance::ground;  // the tank's bottom
    double below = z, above = z + step;
    for (int n = 0; n < 12; ++n) {
        const double middle = 0.5 * (below + above);
        (substance_at(bodies, {x, y, middle}) == io::Substance::nothing ? above : below) = middle;
    }
    top.height = std::max(below, 0.0);
    return top;
}

std::string metres(double length) { return io::format_fixed(length, 0) + " m"; }

// Cliff and ice below the water behind the front, the water's greatest depth before it.
std::vector<io::Measure> measures_of(const scene::Scene& scene, const Bodies& bodies) {
    std::vector<io::Measure> measures;
    const bool water = scene.has("water");
    const double level = scene.water.depth;
    if (bodies.ice) {
        const Glacier& ice = *bodies.ice;
        const double x = ice.front - 0.25 * (ice.front - ice.extent.low[0]);
        const bool cliff = water && ice.base < level && level < ice.top;
        if (cliff) {
            measures.push_back({x, level, ice.top, "cliff " + metres(ice.top - level)});
            measures.push_back({x, ice.base, level, metres(level - ice.base)});
        } else {
            measures.push_back({x, ice.base, ice.top, metres(ice.top - ice.base)});
        }
    }
    if (!water) return measures;
    const double from = bodies.ice ? bodies.ice->front : 0.0,
                 y = scene.dimension == 3 ? 0.5 * scene.domain.size[1] : 0.0;
    const double to = scene.water.length > 0.0 ? scene.water.length : scene.domain.size.front();
    double deepest = from, bed = level;
    for (double x = from + 0.2 * (to - from); x < from + 0.8 * (to - from); x += scene.domain.cell_size) {
        if (ground_height(scene, bodies, x, y) < bed - 1e-9)
            bed = ground_height(scene, bodies, deepest = x, y);
    }
    if (bed < level) measures.push_back({deepest, bed, level, "water " + metres(level - bed)});
    return measures;
}

io::SectionSettings section_settings(const scene::Scene& scene, const Bodies& bodies) {
    const geometry::Extent tank = extent_of(bodies.tank);
    const bool flat = scene.dimension == 2;
    io::SectionSettings settings{.dimension = scene.dimension,
                                 .low = {tank.low[0], flat ? 0.0 : tank.low[1], tank.low[2]},
                                 .high = {tank.high[0], flat ? 0.0 : tank.high[1], tank.high[2]},
                                 .across = flat ? 0.0 : 0.5 * (tank.low[1] + tank.high[1]),
                                 .title = scene.title,
                                 .measures = measures_of(scene, bodies),
                                 .gauges = {},
                                 .at =
                                     [&](double x, double y, double z) {
                                         return substance_at(bodies, {x, y, z});
                                     },
                                 .width = scene.postprocess.picture_width};
    if (scene.has("water")) settings.still_level = scene.water.depth;
    for (const auto& place : gauge_places(scene.simulate.gauges, scene, bodies.terrain.ground))
        settings.gauges.push_back({place.x, place.y});
    if (!flat) settings.top = [&](double x, double y) { return top_at(scene, bodies, x, y); };
    return settings;
}

}  // namespace

void show(const StageContext& context, const Bodies& bodies,
          const std::vector<openvdb::FloatGrid::Ptr>& grids) {
    const scene::Scene& scene = context.scene;
    std::vector<io::NumberedLevelSet> shown;
    for (const auto& grid : grids) {
        if (const std::uint8_t number = number_of(grid->getName()); number != 0)
            shown.push_back({grid, number});
    }
    io::write_surfaces(context.folder / "surfaces.vtp", shown, context.provenance);
    const geometry::Extent tank = extent_of(bodies.tank);
    const io::ImageExtent extent{.dimension = scene.dimension,
                                 .low = {tank.low[0], tank.low[1], tank.low[2]},
                                 .high = {tank.high[0], tank.high[1], tank.high[2]}};
    double values = static_cast<double>(shown.size());
    for (const double length : scene.domain.size) values *= length / scene.domain.cell_size + 1.0;
    io::write_image(context.folder / "image.vti", shown, extent, values < most_values, context.provenance);
    draw_section(section_settings(scene, bodies))
        .canvas.write_png(context.folder / "scene.png", context.provenance);
}

}  // namespace tidewater
