#include "common/ground.h"

#include "core/error.h"
#include "geometry/height_grid.h"
#include "io/vdb.h"

namespace tidewater {

double Ground::height(double x, double y) const {
    if (profile) return profile->height(x);
    return field ? field->height(x, y) : 0.0;
}

Ground read_ground(const scene::Scene& scene, const std::filesystem::path& geometry) {
    if (!scene.has("bed")) return {};
    if (!scene.bed.profile.empty()) return {.profile = bed_profile(scene), .field = {}};
    for (const auto& grid : io::read_level_sets(geometry)) {
        if (grid->getName() == geometry::bed_heights)
            return {.profile = {}, .field = geometry::height_field(*grid)};
    }
    throw InputError(geometry.string() + ": has no '" + geometry::bed_heights +
                     "', the heights of the ground; run tidewater-geometry again");
}

}  // namespace tidewater
