#include "frames.h"

#include "core/error.h"

namespace tidewater::postprocess {

std::string Frames::stamp(std::size_t frame) const {
    const std::filesystem::path& file = files[frame];
    return file.filename().string() + " " + std::to_string(std::filesystem::file_size(file)) + " " +
           std::to_string(std::filesystem::last_write_time(file).time_since_epoch().count());
}

Frames find_frames(const std::filesystem::path& folder) {
    Frames frames{io::list_snapshots(folder), {}};
    for (const auto& file : frames.files) frames.times.push_back(io::read_snapshot_time(file));
    return frames;
}

io::Snapshot read_frame(const Frames& frames, std::size_t frame, const scene::Scene& scene) {
    io::Snapshot snapshot = io::read_snapshot(frames.files[frame]);
    if (snapshot.dimension != scene.dimension) {
        throw InputError(frames.files[frame].string() + ": it has " + std::to_string(snapshot.dimension) +
                         " dimensions, the scene " + std::to_string(scene.dimension) +
                         "; run tidewater-simulate again");
    }
    return snapshot;
}

}  // namespace tidewater::postprocess
