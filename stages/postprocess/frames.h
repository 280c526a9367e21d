// What is made from the snapshots, one frame in memory at a time: the ParaView collection, gauges, profiles
// of the surface, pictures and the page that shows them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "common/stage.h"
#include "gauges.h"
#include "profiles.h"

namespace tidewater::postprocess {

struct Frames {
    std::vector<std::filesystem::path> files;  // in the order of their numbers
    std::vector<double> times;                 // s
};

// Throws InputError if there are no snapshots or one is no whole snapshot of this version.
Frames find_frames(const std::filesystem::path& folder);

// The frames nearest to the wanted times, each once and in order; without wanted times `count` frames evenly
// spread from the first to the last.
std::vector<std::size_t> choose_frames(const std::vector<double>& times, const std::vector<double>& wanted,
                                       std::size_t count);

// The frames to draw, by postprocess.picture_interval or picture_times.
std::vector<std::size_t> choose_pictures(const std::vector<double>& times, const scene::Scene& scene);

// Throws SceneError if postprocess.picture_window is no part of the scene's tank, or the scene is in 3D.
void check_picture_window(const scene::Scene& scene);

struct FromFrames {
    std::vector<GaugeRecord> gauges;  // postprocess.gauges
    SurfaceProfiles profiles;         // empty unless the scene makes a first wave
};

// Writes particles_NNNN.vtp of every frame, particles.pvd, frame_t=<time>.png of the chosen frames and
// frames.html with them, and reads gauges and profiles from every frame. Progress goes to standard error.
FromFrames process_frames(const StageContext& context, const Frames& frames);

}  // namespace tidewater::postprocess
