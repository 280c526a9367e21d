// What is made from the snapshots, one frame in memory at a time: the ParaView collection, gauges, pictures.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "common/stage.h"
#include "gauges.h"

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

// Writes particles_NNNN.vtp of every frame, particles.pvd and frame_t=<time>.png of the chosen frames, and
// reads postprocess.gauges from every frame. Progress goes to standard error.
std::vector<GaugeRecord> process_frames(const StageContext& context, const Frames& frames);

}  // namespace tidewater::postprocess
