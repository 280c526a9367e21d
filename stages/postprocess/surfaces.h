// Surfaces for ParaView: of the water (io/water_surface.h) and around the glacier, icebergs and blocks
// (io/body_surfaces.h); none if postprocess.surfaces is false. Test: tests/pipeline/paraview_test.sh
#pragma once

#include "common/stage.h"
#include "frame_pass.h"

namespace tidewater::postprocess {

// water_surface_NNNN.vtp, in scenes with water. `surface` is the product before it that writes
// frames/surface_NNNN.h5.
FrameProduct water_surface_product(const StageContext& context, const FrameProduct& surface);

// iceberg_surfaces_NNNN.vtp, in scenes with ice or blocks. `icebergs` is the product before it that writes
// frames/members_NNNN.h5. The numbers are those of icebergs.csv, 0 the glacier; blocks have -1, all together.
FrameProduct body_surfaces_product(const StageContext& context, const FrameProduct& icebergs);

}  // namespace tidewater::postprocess
