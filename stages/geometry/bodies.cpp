#include "bodies.h"

#include <algorithm>
#include <cmath>

#include "analysis/wave_theory.h"

namespace tidewater {
namespace {

using geometry::Box;
using geometry::common;
using geometry::Point;
using geometry::Solid;
using geometry::without;

Box upright_box(const scene::Scene& scene, const std::vector<double>& size) {
    std::vector<double> center = size;
    for (double& along : center) along *= 0.5;
    return make_box(scene, center, size);
}

// The volume of a box inside an upright one; both span y alike in 2D.
double shared_volume(const scene::Scene& scene, const Box& box, const Box& upright) {
    const double area = geometry::shared_area(box, upright);
    if (scene.dimension == 2) return area;
    const double low = std::max(box.center[1] - box.half_size[1], upright.center[1] - upright.half_size[1]);
    const double high = std::min(box.center[1] + box.half_size[1], upright.center[1] + upright.half_size[1]);
    return area * std::max(high - low, 0.0);
}

// "block", or "block1", "block2", … of several; from ten on "block01", …, so that the file, which sorts its
// grids by name, keeps them in the scene's order.
std::string block_grid(std::size_t block, std::size_t count) {
    if (count == 1) return "block";
    const std::string number = std::to_string(block + 1);
    return "block" + std::string(std::to_string(count).size() - number.size(), '0') + number;
}

std::vector<BoxBody> boxes_of(const scene::Scene& scene) {
    std::vector<BoxBody> boxes;
    if (scene.has("shelf")) {
        std::vector<double> size = scene.domain.size;
        size.front() = scene.shelf.length;
        size.back() = scene.shelf.height;
        boxes.push_back({"shelf", upright_box(scene, size)});
    }
    for (std::size_t n = 0; scene.has("rigid") && n < scene.blocks.size(); ++n) {
        boxes.push_back(
            {block_grid(n, scene.blocks.size()), block_box(scene, scene.blocks[n]), &scene.blocks[n]});
    }
    return boxes;
}

// Along a wave: a box as high as its crest, cut off at its surface.
std::vector<double> water_size(const scene::Scene& scene) {
    std::vector<double> size = scene.domain.size;
    if (scene.water.length > 0.0) size.front() = scene.water.length;
    size.back() = scene.water.depth + (scene.has("wave") ? scene.wave.height : 0.0);
    return size;
}

// To a wave's surface, m: the distance along z times the cosine of the slope, exact to first order.
double wave_distance(const analysis::InitialWave& wave, const Point& point) {
    const double slope = analysis::elevation_slope(wave, point[0]);
    return (point[2] - wave.depth - analysis::elevation(wave, point[0])) / std::hypot(1.0, slope);
}

Solid open_water(const scene::Scene& scene, const Box& box) {
    if (!scene.has("wave")) return box_solid(box);
    return common(box_solid(box),
                  [wave = initial_wave(scene)](const Point& p) { return wave_distance(wave, p); });
}

Solid water_solid(const Bodies& bodies) {
    Solid water = bodies.open_water;
    for (const BoxBody& body : bodies.boxes) water = without(std::move(water), box_solid(body.box));
    if (bodies.ice) water = without(std::move(water), bodies.ice->whole);
    return without(std::move(water), bodies.ground);
}

// Of a profile's ground in an upright box that begins at x = 0 and z = 0; of a field's by trial.
double ground_in(const scene::Scene& scene, const Bodies& bodies, const Box& box) {
    if (!bodies.terrain.ground.profile) {
        return geometry::volume(common(box_solid(box), bodies.ground), extent_of(box), scene.domain.cell_size,
                                volume_levels(scene.dimension), scene.dimension);
    }
    const double area =
        area_below(*bodies.terrain.ground.profile, 2.0 * box.half_size[0], 2.0 * box.half_size[2]);
    return scene.dimension == 2 ? area : area * 2.0 * box.half_size[1];
}

// Whether all that displaces water is boxes and a profile that share no room.
bool is_simple(const scene::Scene& scene, const Bodies& bodies) {
    const bool plain_ice = scene.ice.profile.empty() && scene.ice.base == scene::IceBase::given &&
                           !bodies.terrain.surface && !scene.has("cliff") && !scene.has("undercut") &&
                           !scene.has("crevasses");
    return (!bodies.ice || plain_ice) && !bodies.terrain.ground.field &&
           !(scene.has("shelf") && scene.has("bed"));
}

double volume_of_water(const scene::Scene& scene, const Bodies& bodies) {
    const Box& water = bodies.water_box;
    if (!is_simple(scene, bodies)) {
        return geometry::volume(bodies.water, extent_of(water), scene.domain.cell_size,
                                volume_levels(scene.dimension), scene.dimension);
    }
    double filled = volume_of(scene, water);
    if (scene.has("wave")) {
        const double length = scene.domain.size.front(),
                     width = scene.dimension == 3 ? scene.domain.size[1] : 1.0;
        filled = width * (length * scene.water.depth + analysis::elevated_area(initial_wave(scene), length));
    }
    for (const BoxBody& body : bodies.boxes) {
        if (body.block == nullptr) filled -= shared_volume(scene, body.box, water);
    }
    if (bodies.ice) filled -= shared_volume(scene, ice_box(scene), water);
    for (const BoxBody& body : bodies.boxes) {
        if (body.block != nullptr) filled -= shared_volume(scene, body.box, water);
    }
    if (scene.has("bed")) filled -= ground_in(scene, bodies, water);
    return filled;
}

}  // namespace

double volume_of(const scene::Scene& scene, const Box& box) {
    const double area = 4.0 * box.half_size[0] * box.half_size[2];
    return scene.dimension == 2 ? area : area * 2.0 * box.half_size[1];
}

geometry::Extent extent_of(const Box& box) {
    const Point reach = box.angle == 0.0 ? box.half_size : Point::Constant(box.half_size.norm());
    return {box.center - reach, box.center + reach};
}

Bodies make_bodies(const scene::Scene& scene) {
    Bodies bodies;
    bodies.terrain = read_terrain(scene);
    bodies.ground = ground_solid(scene, bodies.terrain.ground);
    bodies.tank = upright_box(scene, scene.domain.size);
    bodies.boxes = boxes_of(scene);
    if (scene.has("ice")) bodies.ice = make_glacier(scene, bodies.ground, bodies.terrain.surface);
    if (scene.has("bed")) bodies.ground_volume = ground_in(scene, bodies, bodies.tank);
    if (!scene.has("water")) return bodies;
    bodies.water_box = upright_box(scene, water_size(scene));
    bodies.open_water = open_water(scene, bodies.water_box);
    bodies.water = water_solid(bodies);
    bodies.water_volume = volume_of_water(scene, bodies);
    return bodies;
}

}  // namespace tidewater
