// What ParaView opens beside the products of the frames: their collections and the script of the standard
// view. Test: tests/pipeline/paraview_test.sh
#pragma once

#include "common/stage.h"
#include "frame_pass.h"
#include "frames.h"

namespace tidewater::postprocess {

// In the order in which they are to be made, behind what they read.
struct ParaviewProducts {
    FrameProduct particles, water_surface, iceberg_surfaces;
};

// `icebergs` writes frames/members_NNNN.h5, `surface` frames/surface_NNNN.h5; those that make no files are
// done without.
ParaviewProducts paraview_products(const StageContext& context, const FrameProduct& icebergs,
                                   const FrameProduct& surface);

// particles.pvd, water_surface.pvd and iceberg_surfaces.pvd of those that there are, and view.py, a script
// for ParaView's Python that shows them.
void write_collections(const StageContext& context, const Frames& frames, const ParaviewProducts& products);

}  // namespace tidewater::postprocess
