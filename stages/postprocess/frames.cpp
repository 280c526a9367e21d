#include "frames.h"

#include <algorithm>

#include "core/error.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

// Icebergs are followed by their particles' ids; without ids in the files those are rows.
io::Snapshot read_imported(const Frames& frames, std::size_t frame, const scene::Scene& scene) {
    std::vector<std::string> notes;
    io::Snapshot snapshot = io::read_particle_file(frames.files[frame], *frames.import, &notes);
    snapshot.time = frames.times[frame];
    const bool without_id =
        std::ranges::any_of(notes, [](const std::string& note) { return note.starts_with("no id "); });
    if (scene.has("ice") && without_id && snapshot.particle_count() != frames.first_count) {
        throw InputError(frames.files[frame].string() + ": column id is missing, and its " +
                         std::to_string(snapshot.particle_count()) + " particles cannot be the " +
                         std::to_string(frames.first_count) +
                         " of the first file; name one by --map id=ARRAY");
    }
    return snapshot;
}

}  // namespace

std::string Frames::stamp(std::size_t frame) const {
    const std::filesystem::path& file = files[frame];
    return file.filename().string() + " " + std::to_string(std::filesystem::file_size(file)) + " " +
           std::to_string(std::filesystem::last_write_time(file).time_since_epoch().count()) +
           (import ? "\n" + import_text + " " + io::format_number(times[frame]) : "");
}

Frames find_frames(const std::filesystem::path& folder) {
    Frames frames;
    frames.files = io::list_snapshots(folder);
    for (const auto& file : frames.files) frames.times.push_back(io::read_snapshot_time(file));
    return frames;
}

io::Snapshot read_frame(const Frames& frames, std::size_t frame, const scene::Scene& scene) {
    io::Snapshot snapshot =
        frames.import ? read_imported(frames, frame, scene) : io::read_snapshot(frames.files[frame]);
    if (snapshot.dimension != scene.dimension) {
        throw InputError(frames.files[frame].string() + ": it has " + std::to_string(snapshot.dimension) +
                         " dimensions, the scene " + std::to_string(scene.dimension) +
                         "; run tidewater-simulate again");
    }
    return snapshot;
}

}  // namespace tidewater::postprocess
