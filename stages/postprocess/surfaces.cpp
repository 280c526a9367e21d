#include "surfaces.h"

#include <map>
#include <utility>

#include "analysis/surface_speed.h"
#include "core/types.h"
#include "io/body_surfaces.h"
#include "io/surface_file.h"
#include "io/water_surface.h"
#include "particles.h"

namespace tidewater::postprocess {
namespace {

std::vector<float> speeds(const io::Surface& surface, const io::Snapshot& snapshot, double cell_size) {
    std::vector<float> level;
    for (const float eta : surface.elevation) level.push_back(static_cast<float>(surface.still_level) + eta);
    return analysis::surface_speed({snapshot.points, snapshot.volume, snapshot.material}, snapshot.velocity,
                                   {surface.x, surface.y, level, cell_size});
}

// The icebergs in the order of their numbers, and all blocks before them.
std::vector<io::Body> bodies_of(const std::vector<std::int32_t>& icebergs, const io::Snapshot& snapshot) {
    std::map<std::pair<std::int32_t, std::uint8_t>, io::Body> bodies;
    for (std::size_t p = 0; p < snapshot.particle_count(); ++p) {
        const std::int32_t iceberg = icebergs.empty() ? -1 : icebergs[p];
        const auto material = snapshot.material[p];
        if (iceberg < 0 && static_cast<Material>(material) != Material::rigid) continue;
        io::Body& body = bodies[{iceberg, material}];
        body.iceberg = iceberg;
        body.material = material;
        body.particles.push_back(static_cast<std::uint32_t>(p));
    }
    std::vector<io::Body> list;
    for (auto& [number, body] : bodies) list.push_back(std::move(body));
    return list;
}

// Of one frame, if there are any.
std::function<std::vector<std::string>(std::size_t)> file_of(bool any, std::string (*name)(std::size_t)) {
    return [=](std::size_t frame) { return any ? std::vector{name(frame)} : std::vector<std::string>{}; };
}

}  // namespace

FrameProduct water_surface_product(const StageContext& context, const FrameProduct& surface) {
    return {.name = "water surface",
            .settings = surface.settings,
            .files = file_of(context.scene.postprocess.surfaces && !surface.files(0).empty(),
                             &io::water_surface_name),
            .make =
                [folder = context.folder, cell = context.scene.domain.cell_size](
                    std::size_t frame, const io::Snapshot& snapshot, const Provenance& provenance) {
                    const auto of_frame = io::read_surface(folder / frame_file("surface", frame, "h5"));
                    io::write_water_surface(folder / io::water_surface_name(frame), of_frame,
                                            speeds(of_frame, snapshot, cell), provenance);
                },
            .follows = false};
}

FrameProduct body_surfaces_product(const StageContext& context, const FrameProduct& icebergs) {
    const scene::Scene& scene = context.scene;
    const bool followed = !icebergs.files(0).empty();
    return {.name = "iceberg surfaces",
            .settings = icebergs.settings,
            .files = file_of(scene.postprocess.surfaces && (followed || scene.has("rigid")),
                             &io::body_surfaces_name),
            .make =
                [folder = context.folder, spacing = particle_spacing(scene)](
                    std::size_t frame, const io::Snapshot& snapshot, const Provenance& provenance) {
                    const auto bodies = bodies_of(icebergs_of(folder, frame, snapshot), snapshot);
                    io::write_body_surfaces(folder / io::body_surfaces_name(frame),
                                            {snapshot.dimension, spacing, snapshot.points, snapshot.volume},
                                            bodies, provenance);
                },
            .follows = followed};
}

}  // namespace tidewater::postprocess
