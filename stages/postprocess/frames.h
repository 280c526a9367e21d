// The frames of a simulated run: which there are, when they are of, and what is in one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/particle_files.h"
#include "io/snapshot.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

struct Frames {
    std::vector<std::filesystem::path> files;  // in the order of their times
    std::vector<double> times;                 // s

    // Of another program's frames: how they are read, the same as text, and how many particles the first has.
    std::optional<io::ParticleImport> import;
    std::string import_text;
    std::size_t first_count = 0;

    // Name, size and time of the last change of a frame's file, and how it is read, as text: another one if
    // the file is another.
    std::string stamp(std::size_t frame) const;
};

// Those that are there, of a run that still grows too. Throws InputError if there are no snapshots or one is
// no whole snapshot of this version.
Frames find_frames(const std::filesystem::path& folder);

// Throws InputError if the file is damaged or of another dimension than the scene; of another program also if
// its particles cannot be told apart.
io::Snapshot read_frame(const Frames& frames, std::size_t frame, const scene::Scene& scene);

}  // namespace tidewater::postprocess
