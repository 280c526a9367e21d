// The particles of every frame for ParaView: particles_NNNN.vtp and particles.pvd.
#pragma once

#include "common/stage.h"
#include "frame_pass.h"
#include "frames.h"

namespace tidewater::postprocess {

FrameProduct particles_product(const StageContext& context);

// particles.pvd, of the files that the product made.
void write_particles_collection(const StageContext& context, const Frames& frames);

}  // namespace tidewater::postprocess
