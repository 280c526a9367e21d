// How the ice broke, measured where it was at rest: the first crack and the first iceberg, from the times at
// which particles failed, and the main event, from the icebergs that were followed.
#pragma once

#include "break_records.h"
#include "common/stage.h"
#include "frame_pass.h"
#include "frames.h"

namespace tidewater::postprocess {

// Of the last frame: first_iceberg.csv where particles have failure times, and main_event.csv. No files of
// a scene without ice. Particles are matched with the first frame's, where the ice is at rest, by their ids;
// one that is no longer there counts as intact. Comes after icebergs_product; `frames` must outlive it.
FrameProduct first_iceberg_product(const StageContext& context, const Frames& frames);

}  // namespace tidewater::postprocess
