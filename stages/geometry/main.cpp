// tidewater-geometry: the scene's tank, bed, shelf, water, ice and blocks as level sets in
// <run>/geometry/geometry.vdb.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "analysis/wave_theory.h"
#include "common/stage.h"
#include "core/error.h"
#include "core/hash.h"
#include "geometry/level_set.h"
#include "geometry/profile.h"
#include "io/vdb.h"

namespace tidewater {
namespace {

using geometry::Box;
using geometry::Extent;
using geometry::Point;

Box upright_box(const scene::Scene& scene, std::vector<double> size) {
    std::vector<double> center = size;
    for (double& along : center) along *= 0.5;
    return make_box(scene, center, size);
}

// Volume of a box in m³, in 2D its area in m².
double volume(const scene::Scene& scene, const Box& box) {
    const double area = 4.0 * box.half_size[0] * box.half_size[2];
    return scene.dimension == 2 ? area : area * 2.0 * box.half_size[1];
}

// The volume of a block inside an upright box; both span y alike in 2D.
double shared_volume(const scene::Scene& scene, const Box& block, const Box& upright) {
    const double area = geometry::shared_area(block, upright);
    if (scene.dimension == 2) return area;
    const double low =
        std::max(block.center[1] - block.half_size[1], upright.center[1] - upright.half_size[1]);
    const double high =
        std::min(block.center[1] + block.half_size[1], upright.center[1] + upright.half_size[1]);
    return area * std::max(high - low, 0.0);
}

Extent extent_of(const Box& box) {
    const Point reach = box.angle == 0.0 ? box.half_size : Point::Constant(box.half_size.norm());
    return {box.center - reach, box.center + reach};
}

// What displaces water; no two of them overlap.
struct Solid {
    std::string name;
    Box box;
    const scene::Scene::Block* block = nullptr;  // null for the shelf and the ice
};

// "block", or "block1", "block2", … of several; from ten on "block01", …, so that the file, which sorts its
// grids by name, keeps them in the scene's order.
std::string block_grid(std::size_t block, std::size_t count) {
    if (count == 1) return "block";
    const std::string number = std::to_string(block + 1);
    return "block" + std::string(std::to_string(count).size() - number.size(), '0') + number;
}

std::vector<Solid> solids_of(const scene::Scene& scene) {
    std::vector<Solid> solids;
    if (scene.has("shelf")) {
        std::vector<double> size = scene.domain.size;
        size.front() = scene.shelf.length;
        size.back() = scene.shelf.height;
        solids.push_back({"shelf", upright_box(scene, size)});
    }
    if (scene.has("ice")) solids.push_back({"ice", ice_box(scene)});
    for (std::size_t n = 0; scene.has("rigid") && n < scene.blocks.size(); ++n) {
        solids.push_back(
            {block_grid(n, scene.blocks.size()), block_box(scene, scene.blocks[n]), &scene.blocks[n]});
    }
    return solids;
}

// Volume of the ground in an upright box that begins at x = 0 and z = 0, as volume() gives it.
double ground_volume(const scene::Scene& scene, const Box& box) {
    const double area = area_below(bed_profile(scene), 2.0 * box.half_size[0], 2.0 * box.half_size[2]);
    return scene.dimension == 2 ? area : area * 2.0 * box.half_size[1];
}

openvdb::FloatGrid::Ptr bed_level_set(const scene::Scene& scene) {
    const geometry::Profile profile = bed_profile(scene);
    const Box tank = upright_box(scene, scene.domain.size);
    return geometry::make_level_set("bed", scene.domain.cell_size, extent_of(tank), [&](const Point& point) {
        return std::max(signed_distance(tank, point), signed_distance(profile, point));
    });
}

// Along a wave: a box as high as its crest, cut off at its surface.
std::vector<double> water_size(const scene::Scene& scene) {
    std::vector<double> size = scene.domain.size;
    if (scene.water.length > 0.0) size.front() = scene.water.length;
    size.back() = scene.water.depth + (scene.has("wave") ? scene.wave.height : 0.0);
    return size;
}

// Of the box that water_size gives; m³, in 2D m².
double water_volume(const scene::Scene& scene, const Box& water) {
    if (!scene.has("wave")) return volume(scene, water);
    const double length = scene.domain.size.front(),
                 width = scene.dimension == 3 ? scene.domain.size[1] : 1.0;
    return width * (length * scene.water.depth + analysis::elevated_area(initial_wave(scene), length));
}

// To a wave's surface, m: the distance along z times the cosine of the slope, exact to first order.
double wave_distance(const analysis::InitialWave& wave, const Point& point) {
    const double slope = analysis::elevation_slope(wave, point[0]);
    return (point[2] - wave.depth - analysis::elevation(wave, point[0])) / std::hypot(1.0, slope);
}

openvdb::FloatGrid::Ptr water_level_set(const scene::Scene& scene, const Box& water,
                                        const std::vector<Solid>& solids) {
    const geometry::Profile profile = bed_profile(scene);
    const bool waves = scene.has("wave");
    const analysis::InitialWave wave = initial_wave(scene);
    const auto distance = [&](const Point& point) {
        double to_water = signed_distance(water, point);
        if (waves) to_water = std::max(to_water, wave_distance(wave, point));
        for (const Solid& solid : solids) to_water = std::max(to_water, -signed_distance(solid.box, point));
        if (scene.has("bed")) to_water = std::max(to_water, -signed_distance(profile, point));
        return to_water;
    };
    auto grid = geometry::make_level_set("water", scene.domain.cell_size, extent_of(water), distance);
    double filled = water_volume(scene, water);
    for (const Solid& solid : solids) filled -= shared_volume(scene, solid.box, water);
    if (scene.has("bed")) filled -= ground_volume(scene, water);
    geometry::describe_body(*grid, Material::water, filled);
    return grid;
}

openvdb::FloatGrid::Ptr box_level_set(const scene::Scene& scene, const std::string& name, const Box& box) {
    return geometry::make_level_set(name, scene.domain.cell_size, extent_of(box),
                                    [&](const Point& point) { return signed_distance(box, point); });
}

// How a block floats, if it does: a hint for whoever wants it to start at rest.
void print_floating(const scene::Scene& scene, const Solid& solid) {
    const double area = 4.0 * solid.box.half_size[0] * solid.box.half_size[2];
    const double below = area_below(solid.box, scene.water.depth) / area;
    const double share = solid.block->density / scene.water.model.density;
    std::printf("  %.4g %% of it starts below the still level; ", 100.0 * below);
    if (share >= 1.0) {
        std::printf("it sinks: %.4g times as dense as water\n", share);
        return;
    }
    std::printf("it floats with %.4g %% below, at this angle with its centre at z = %.6g m\n", 100.0 * share,
                floating_height(solid.box, scene.water.depth, share));
}

void print_solid(const scene::Scene& scene, const Solid& solid) {
    const bool flat = scene.dimension == 2;
    const double size = volume(scene, solid.box);
    std::printf("%s: %.6g %s", solid.name.c_str(), size, flat ? "m²" : "m³");
    if (solid.block != nullptr) std::printf(", %.6g %s", size * solid.block->density, flat ? "kg/m" : "kg");
    std::printf("\n");
    if (solid.block != nullptr && scene.has("water")) print_floating(scene, solid);
}

void write_geometry(StageContext& context) {
    const scene::Scene& scene = context.scene;
    const char* unit = scene.dimension == 2 ? "m²" : "m³";
    std::vector<openvdb::FloatGrid::Ptr> grids;
    grids.push_back(box_level_set(scene, "tank", upright_box(scene, scene.domain.size)));

    if (scene.has("bed")) {
        grids.push_back(bed_level_set(scene));
        std::printf("bed: %.6g %s\n", ground_volume(scene, upright_box(scene, scene.domain.size)), unit);
    }
    const std::vector<Solid> solids = solids_of(scene);
    if (scene.has("water")) {
        grids.push_back(water_level_set(scene, upright_box(scene, water_size(scene)), solids));
        std::printf("water: %.6g %s\n", geometry::body_volume(*grids.back()), unit);
    }
    for (const Solid& solid : solids) {
        grids.push_back(box_level_set(scene, solid.name, solid.box));
        print_solid(scene, solid);
        if (solid.name == "shelf") continue;
        geometry::describe_body(*grids.back(), solid.name == "ice" ? Material::ice : Material::rigid,
                                volume(scene, solid.box));
    }
    const std::string fingerprint = hash_hex(hash_text(stage_part(scene, scene::Stage::geometry)));
    for (const auto& grid : grids) geometry::mark_scene(*grid, fingerprint);
    const auto path = context.folder / "geometry.vdb";
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error)
        throw OutputError(path.string() + ": cannot be removed: " + error.message() + "; remove it by hand");
    write_resolved_scene(context);
    io::write_level_sets(path, grids, context.provenance);
    std::printf("wrote %s: %zu level sets, voxel size %g m\n", path.c_str(), grids.size(),
                scene.domain.cell_size);
}

}  // namespace
}  // namespace tidewater

int main(int argc, char** argv) {
    using namespace tidewater;
    return run_stage(argc, argv, scene::Stage::geometry,
                     "Writes the scene's tank, bed, shelf, water, ice and blocks as OpenVDB level sets.",
                     write_geometry);
}
