// From a scene and the geometry stage's level sets to particles.
#pragma once

#include <filesystem>

#include "mpm/step/start.h"
#include "scene/scene.h"

namespace tidewater {

// Seeds every body of the level sets in `file`. A body's mass is its exact volume times its material's
// density, shared equally among its particles; water starts hydrostatic below water.depth, or as the wave of
// the effect "wave". Throws InputError if the file cannot be used or was made for another scene, SceneError
// if it holds no particles.
template <int D>
mpm::Start<D> make_start(const scene::Scene& scene, const std::filesystem::path& file);

// Of all bodies and their particles: what a run begins with beside its scene.
template <int D>
std::string start_fingerprint(const mpm::Start<D>& start);

}  // namespace tidewater
