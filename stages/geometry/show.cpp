#include "show.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/tank.h"
#include "io/level_set_files.h"
#include "io/rasterise.h"
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
        return body.block == nullptr ? io::Substance::bed : io::Substance::rigid;
    }
    if (bodies.ground && bodies.ground(at) <= 0.0) return io::Substance::bed;
    if (bodies.ice && bodies.ice->shown(at) <= 0.0) return io::Substance::ice;
    return bodies.water && bodies.open_water(at) <= 0.0 ? io::Substance::water : io::Substance::nothing;
}

// To the nearest of them, m.
double distance_to_any(const Bodies& bodies, const geometry::Point& at) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const BoxBody& body : bodies.boxes) nearest = std::min(nearest, signed_distance(body.box, at));
    if (bodies.ground) nearest = std::min(nearest, bodies.ground(at));
    if (bodies.ice) nearest = std::min(nearest, bodies.ice->shown(at));
    if (bodies.water) nearest = std::min(nearest, bodies.open_water(at));
    return nearest;
}

double ground_height(const scene::Scene& scene, const Bodies& bodies, double x, double y) {
    const double bed = bodies.terrain.ground.height(x, y);
    return scene.has("shelf") && x <= scene.shelf.length ? std::max(bed, scene.shelf.height) : bed;
}

// The uppermost that is met on the way down: no step is longer than what is nearest.
io::Top top_at(const scene::Scene& scene, const Bodies& bodies, double x, double y) {
    const double least_step = scene.domain.cell_size / 16.0;
    double below = scene.domain.size.back(), above = below;
    for (double room = least_step; below > 0.0 && room > 0.0;) {
        room = distance_to_any(bodies, {x, y, below});
        if (room > 0.0) above = std::exchange(below, std::max(below - std::max(room, least_step), 0.0));
    }
    for (int n = 0; n < 30; ++n) {
        const double middle = 0.5 * (below + above);
        (distance_to_any(bodies, {x, y, middle}) > 0.0 ? above : below) = middle;
    }
    io::Top top{.substance = substance_at(bodies, {x, y, below}),
                .height = below,
                .bed = ground_height(scene, bodies, x, y)};
    if (top.substance == io::Substance::nothing) top.substance = io::Substance::bed;  // the tank's bottom
    if (top.substance == io::Substance::water && !scene.has("wave")) top.height = scene.water.depth;
    return top;
}

std::string metres(double length) { return io::format_fixed(length, 0) + " m"; }

// Cliff and ice below the water before the front, the water's greatest depth before it.
std::vector<io::Measure> measures_of(const scene::Scene& scene, const Bodies& bodies) {
    std::vector<io::Measure> measures;
    const bool water = scene.has("water");
    const double level = scene.water.depth;
    if (bodies.ice) {
        const Glacier& ice = *bodies.ice;
        const double x = ice.extent.high[0] + 0.02 * scene.domain.size[0];
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
                                 .title = "The scene at its start",
                                 .measures = measures_of(scene, bodies),
                                 .gauges = {},
                                 .at =
                                     [&](double x, double y, double z) {
                                         return substance_at(bodies, {x, y, z});
                                     },
                                 .width = 1600};
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
    const io::Drawing section = draw_section(section_settings(scene, bodies)).drawing;
    io::write_svg_and_png(context.folder / "scene.svg", section.svg(context.provenance), 1.0,
                          context.provenance);
}

}  // namespace tidewater
