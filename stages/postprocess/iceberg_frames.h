// The icebergs of each frame: found as fragments of intact ice, followed by their particles, described.
//
// Ice is intact where it has not failed and has lost less than postprocess.iceberg_damage of the strength
// that it had in the first frame (what is weak from the start, as in cracks with cohesion, is intact);
// without failure times and damage all ice is. Where in the first frame ice lies within a cell of the left
// wall, there is a glacier: whatever hangs together with what was its rear then (analysis/calving.h), by
// particle ids, is iceberg 0, and all else are icebergs. Ice that touches no left wall floats free: it has no
// glacier. A file without ids has the particles' places in it as such.
//
// Files of a frame, from which iceberg_tables.h gathers those of the run:
//     frames/icebergs_NNNN.csv         a row per iceberg: its state (analysis/iceberg_state.h)
//     frames/glacier_NNNN.csv          one row: volumes of ice by what became of it, and the front
//     frames/iceberg_events_NNNN.csv   a row per split, merger and end, with a break's distance
//     frames/members_NNNN.h5           which particle is in which iceberg
#pragma once

#include <filesystem>

#include "common/ground.h"
#include "common/stage.h"
#include "frame_pass.h"
#include "io/members_file.h"

namespace tidewater::postprocess {

// No files if the scene has no ice. `frames` must outlive the product.
FrameProduct icebergs_product(const StageContext& context, const Frames& frames, const Ground& ground);

// frames/members_NNNN.h5 of a run's folder of results. Throws InputError.
io::Members read_members(const std::filesystem::path& folder, std::size_t frame);

}  // namespace tidewater::postprocess
