// Frames that another program wrote, named by --particles.
// Test: tests/pipeline/import_test.sh
#pragma once

#include "common/stage.h"
#include "frames.h"

namespace tidewater::postprocess {

// The files of context.particles with what the scene tells of them: the dimension, the material where there
// is only one, and as volume of a particle that of the scene's own, (Δx / per_axis)^dimension. Reads the
// first one as a whole and says what is put in the place of what it does not have, and if its particles lie
// outside of the scene's tank. Throws SceneError if the options are wrong, InputError if the files are.
Frames import_frames(const StageContext& context);

}  // namespace tidewater::postprocess
