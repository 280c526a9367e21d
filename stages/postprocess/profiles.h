// The water's surface along the tank, read from the snapshots, for the wave that a block makes.
#pragma once

#include <vector>

#include "analysis/first_wave.h"
#include "common/ground.h"
#include "common/stage.h"
#include "frame_pass.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

struct SurfaceProfiles {
    std::vector<double> x;                          // m, of the places: a cell apart, at mid-width in 3D
    std::vector<analysis::SurfaceProfile> of_time;  // one per frame
};

// Whether a scene has a block, water and gravity, and so a first wave.
bool makes_first_wave(const scene::Scene& scene);

// frames/profile_NNNN.csv of every frame, x (m) and elevation (m), and the profiles gathered from them; no
// files and no profiles in a scene that makes no first wave. There is no elevation where a block covers the
// place or comes within a cell of it, also deep below, for the surface over a block is no wave's.
FrameProduct profile_product(const StageContext& context, const Ground& ground);
SurfaceProfiles gather_profiles(const StageContext& context, const Frames& frames);

}  // namespace tidewater::postprocess
