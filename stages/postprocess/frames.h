// The frames of a simulated run: which there are, when they are of, and what is in one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/snapshot.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

struct Frames {
    std::vector<std::filesystem::path> files;  // in the order of their times
    std::vector<double> times;                 // s

    // Name, size and time of the last change of a frame's file, as text: another one if the file is another.
    std::string stamp(std::size_t frame) const;
};

// Those that are there, of a run that still grows too. Throws InputError if there are no snapshots or one is
// no whole snapshot of this version.
Frames find_frames(const std::filesystem::path& folder);

// Throws InputError if the file is damaged or of another dimension than the scene.
io::Snapshot read_frame(const Frames& frames, std::size_t frame, const scene::Scene& scene);

}  // namespace tidewater::postprocess
