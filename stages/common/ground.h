// The ground of a scene, from the scene's profile or from what the geometry stage made of an elevation model.
#pragma once

#include <filesystem>
#include <optional>

#include "geometry/height_field.h"
#include "scene/scene.h"

namespace tidewater {

struct Ground {
    std::optional<geometry::Profile> profile;
    std::optional<geometry::HeightField> field;

    bool exists() const { return profile || field; }
    // m; 0 without ground.
    double height(double x, double y) const;
};

// `geometry`: the run's geometry.vdb, read only where the scene's ground is an elevation model. Throws
// InputError if it is not there or lacks it.
Ground read_ground(const scene::Scene& scene, const std::filesystem::path& geometry);

}  // namespace tidewater
