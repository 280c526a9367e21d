// The particles of every frame for ParaView: particles_NNNN.vtp, with what follows from the
// snapshots and from the icebergs found in them. Test: tests/pipeline/paraview_test.sh
#pragma once

#include "common/stage.h"
#include "frame_pass.h"

namespace tidewater::postprocess {

// No files if postprocess.decimation is 0. `icebergs` is the product before it that writes
// frames/members_NNNN.h5; where it makes no files there are no icebergs.
FrameProduct particles_product(const StageContext& context, const FrameProduct& icebergs);

// The iceberg of each particle of the snapshot: 0 of the glacier, -1 of none; empty if the frame has no
// frames/members_NNNN.h5.
std::vector<std::int32_t> icebergs_of(const std::filesystem::path& folder, std::size_t frame,
                                      const io::Snapshot& snapshot);

}  // namespace tidewater::postprocess
