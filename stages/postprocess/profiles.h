// The water's surface along the tank, read from the snapshots, for the wave that a block makes.
#pragma once

#include <vector>

#include "analysis/first_wave.h"
#include "common/ground.h"
#include "io/snapshot.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

struct SurfaceProfiles {
    std::vector<double> x;                          // m, of the places: a cell apart, at mid-width in 3D
    std::vector<analysis::SurfaceProfile> of_time;  // one per frame
};

// Whether a scene has a block, water and gravity, and so a first wave.
bool makes_first_wave(const scene::Scene& scene);

// The places; none in a scene that makes no first wave.
SurfaceProfiles start_profiles(const scene::Scene& scene);

// Adds the profile of a frame, if there are places; without an elevation where a block covers the place or
// comes within a cell of it, also deep below, for the surface over a block is no wave's.
void append_profile(const io::Snapshot& snapshot, const scene::Scene& scene, const Ground& ground,
                    SurfaceProfiles& profiles);

}  // namespace tidewater::postprocess
