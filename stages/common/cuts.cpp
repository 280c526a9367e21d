#include "common/cuts.h"

#include "core/error.h"
#include "io/table.h"

namespace tidewater {
namespace {

// In all of the ice's box, and where its front bulges out of it.
geometry::CrackSettings crack_settings(const scene::Scene& scene) {
    const geometry::Box box = ice_box(scene);
    const geometry::Point bulge(scene.has("cliff") ? scene.cliff.amplitude : 0.0, 0.0, 0.0);
    return {.cell_size = scene.cracks.cell_size,
            .width = scene.cracks.width,
            .cohesion = scene.cracks.cohesion,
            .region = {box.center - box.half_size, box.center + box.half_size + bulge},
            .dimension = scene.dimension,
            .seed = scene.seed};
}

}  // namespace

std::optional<geometry::Crevasses> scene_crevasses(const scene::Scene& scene) {
    if (!scene.has("crevasses")) return {};
    const auto& asked = scene.crevasses;
    const bool flat = scene.dimension == 2;
    return geometry::make_crevasses(
        {.depth = {asked.depth[0], asked.depth[1]},
         .opening = {asked.opening[0], asked.opening[1]},
         .spacing = asked.spacing,
         .angle = flat ? 0.0 : asked.angle,
         .wander = flat ? 0.0 : asked.wander,
         .wavelength = asked.wavelength,
         .length = flat ? 0.0 : asked.length,
         .from = asked.from,
         .to = asked.to > 0.0 ? asked.to : scene.ice.corner[0] + scene.ice.size[0],
         .width = flat ? 0.0 : scene.domain.size[1],
         .seed = scene.seed});
}

std::optional<geometry::Cracks> scene_cracks(const scene::Scene& scene) {
    if (!scene.has("cracks")) return {};
    return geometry::make_cracks(crack_settings(scene));
}

void write_cracks(const std::filesystem::path& path, const geometry::Cracks& cracks,
                  const Provenance& provenance) {
    io::TableWriter table(path, provenance, {"x", "y", "z"});
    for (const geometry::Point& site : cracks.sites) table.append(std::array{site[0], site[1], site[2]});
    table.finish();
}

geometry::Cracks read_cracks(const std::filesystem::path& path, const scene::Scene& scene) {
    const io::Table table = io::read_table(path);
    const auto &x = io::require_column(table, "x", path), &y = io::require_column(table, "y", path),
               &z = io::require_column(table, "z", path);
    geometry::Cracks cracks{.settings = crack_settings(scene), .sites = {}};
    for (std::size_t n = 0; n < x.size(); ++n) cracks.sites.emplace_back(x[n], y[n], z[n]);
    if (cracks.sites.size() < 2)
        throw InputError(path.string() +
                         ": has no two sites, so there are no cracks; run tidewater-geometry again");
    return cracks;
}

}  // namespace tidewater
