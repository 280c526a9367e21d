// tidewater-geometry: the scene's tank, bed, shelf, water, ice and blocks as level sets in
// <run>/geometry/geometry.vdb, and pictures of them.
#include <cstdio>

#include "common/stage.h"
#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "geometry/height_grid.h"
#include "io/vdb.h"
#include "show.h"
#include "summary.h"

namespace tidewater {
namespace {

using geometry::common;
using Grids = std::vector<openvdb::FloatGrid::Ptr>;

openvdb::FloatGrid::Ptr level_set(const scene::Scene& scene, const std::string& name,
                                  const geometry::Extent& extent, const geometry::Solid& solid) {
    return geometry::make_level_set(name, scene.domain.cell_size, extent, solid);
}

// The ice as it is, and, where cuts are thinner than the level set can hold, the ice that simulate seeds
// before it leaves out what is cut.
void add_ice(const scene::Scene& scene, const Glacier& ice, Grids& grids) {
    grids.push_back(level_set(scene, "ice", ice.extent, ice.shown));
    if (ice.crevasses || ice.cracks) {
        grids.push_back(level_set(scene, "ice_uncut", ice.extent, ice.uncut));
        grids.push_back(geometry::height_grid(geometry::ice_surface, ice.surface));
    }
    auto& seeded = *grids[grids.size() - (ice.crevasses || ice.cracks ? 2 : 1)];
    geometry::describe_body(seeded, Material::ice, ice.volume);
}

Grids make_grids(const scene::Scene& scene, const Bodies& bodies) {
    const geometry::Extent tank = extent_of(bodies.tank);
    Grids grids{level_set(scene, "tank", tank, box_solid(bodies.tank))};
    if (bodies.ground) {
        grids.push_back(level_set(scene, "bed", tank, common(box_solid(bodies.tank), bodies.ground)));
        if (bodies.terrain.ground.field)
            grids.push_back(geometry::height_grid(geometry::bed_heights, *bodies.terrain.ground.field));
    }
    if (bodies.water) {
        grids.push_back(level_set(scene, "water", extent_of(bodies.water_box), bodies.water));
        geometry::describe_body(*grids.back(), Material::water, bodies.water_volume);
    }
    for (const BoxBody& body : bodies.boxes) {
        if (body.block == nullptr)
            grids.push_back(level_set(scene, body.name, extent_of(body.box), box_solid(body.box)));
    }
    if (bodies.ice) add_ice(scene, *bodies.ice, grids);
    for (const BoxBody& body : bodies.boxes) {
        if (body.block == nullptr) continue;
        grids.push_back(level_set(scene, body.name, extent_of(body.box), box_solid(body.box)));
        geometry::describe_body(*grids.back(), Material::rigid, volume_of(scene, body.box));
    }
    const std::string fingerprint = hash_hex(hash_text(stage_part(scene, scene::Stage::geometry)));
    for (const auto& grid : grids) geometry::mark_scene(*grid, fingerprint);
    return grids;
}

void remove_earlier(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string ending = entry.path().extension();
        if (ending != ".vdb" && ending != ".csv" && ending != ".vtp" && ending != ".vti" &&
            ending != ".png" && ending != ".txt")
            continue;
        std::error_code error;
        std::filesystem::remove(entry.path(), error);
        if (error) {
            throw OutputError(entry.path().string() + ": cannot be removed: " + error.message() +
                              "; remove it by hand");
        }
    }
}

void write_geometry(StageContext& context) {
    const scene::Scene& scene = context.scene;
    const Bodies bodies = make_bodies(scene);
    const std::string text = summary(scene, bodies);
    std::fputs(text.c_str(), stdout);
    const Grids grids = make_grids(scene, bodies);
    remove_earlier(context.folder);
    write_resolved_scene(context);
    write_text(context.folder / "summary.txt", text);
    if (bodies.ice && bodies.ice->cracks)
        write_cracks(context.folder / "cracks.csv", *bodies.ice->cracks, context.provenance);
    show(context, bodies, grids);
    const auto path = context.folder / "geometry.vdb";  // the last: make takes it for the stage's end
    io::write_level_sets(path, grids, context.provenance);
    std::printf("wrote %s: %zu grids, voxel size %g m\n", path.c_str(), grids.size(), scene.domain.cell_size);
}

}  // namespace
}  // namespace tidewater

int main(int argc, char** argv) {
    using namespace tidewater;
    return run_stage(
        argc, argv, scene::Stage::geometry,
        "Writes the scene's tank, bed, shelf, water, ice and blocks as OpenVDB level sets, and shows them.",
        write_geometry);
}
