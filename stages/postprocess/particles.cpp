#include "particles.h"

#include "io/collection.h"

namespace tidewater::postprocess {

FrameProduct particles_product(const StageContext& context) {
    return {.name = "particles",
            .settings = {},
            .files = [](std::size_t frame) { return std::vector{io::particles_name(frame)}; },
            .make =
                [folder = context.folder](std::size_t frame, const io::Snapshot& snapshot,
                                          const Provenance& provenance) {
                    io::write_particles(folder / io::particles_name(frame), snapshot, {}, provenance);
                },
            .follows = false};
}

void write_particles_collection(const StageContext& context, const Frames& frames) {
    std::vector<io::CollectionEntry> entries;
    for (std::size_t frame = 0; frame < frames.times.size(); ++frame)
        entries.push_back({io::particles_name(frame), frames.times[frame]});
    io::write_collection(context.folder / "particles.pvd", entries, context.provenance);
}

}  // namespace tidewater::postprocess
