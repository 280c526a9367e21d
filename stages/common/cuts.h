// What is cut out of a scene's ice, thinner than a level set can hold: crevasses, which follow from the
// scene, and Voronoi cracks, whose sites the geometry stage leaves in cracks.csv.
#pragma once

#include <filesystem>
#include <optional>

#include "core/provenance.h"
#include "geometry/cracks.h"
#include "geometry/crevasses.h"
#include "geometry/height_field.h"
#include "geometry/solid.h"
#include "scene/scene.h"

namespace tidewater {

// Nothing without the effect.
std::optional<geometry::Crevasses> scene_crevasses(const scene::Scene& scene);
std::optional<geometry::Cracks> scene_cracks(const scene::Scene& scene);

// The crevasses below a surface; empty where there are none. Refers to what it is given.
geometry::Solid crevasse_solid(const geometry::Crevasses& crevasses, const geometry::HeightField& surface);

// cracks.csv: one row for each site, x, y, z in m.
void write_cracks(const std::filesystem::path& path, const geometry::Cracks& cracks,
                  const Provenance& provenance);
// With the scene's settings. Throws InputError if the file is missing or is no such table.
geometry::Cracks read_cracks(const std::filesystem::path& path, const scene::Scene& scene);

}  // namespace tidewater
