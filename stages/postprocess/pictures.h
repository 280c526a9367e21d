// Pictures of chosen frames, and the page that shows them one after the other.
#pragma once

#include <cstddef>
#include <vector>

#include "common/ground.h"
#include "common/stage.h"
#include "frame_pass.h"
#include "frames.h"

namespace tidewater::postprocess {

// The frames nearest to the wanted times, each once and in order; without wanted times `count` frames evenly
// spread from the first to the last.
std::vector<std::size_t> choose_frames(const std::vector<double>& times, const std::vector<double>& wanted,
                                       std::size_t count);

// The frames to draw, by postprocess.picture_interval or picture_times.
std::vector<std::size_t> choose_pictures(const std::vector<double>& times, const scene::Scene& scene);

// Throws SceneError if postprocess.picture_window is no part of the scene's tank, or the scene is in 3D.
void check_picture_window(const scene::Scene& scene);

// How fast the water of the chosen frames is, from which the colour scale of all pictures follows:
// frames/speed_NNNN.csv. Nothing where the scene sets the scale.
FrameProduct speed_product(const StageContext& context, const std::vector<std::size_t>& chosen);

// Makes frame_t=<time>.png and .svg of the chosen frames, of which speed_product has been made, and
// frames.html.
// `icebergs` is the product before it that writes frames/members_NNNN.h5, by which postprocess.picture_ice =
// "iceberg" colours ice.
void make_pictures(const StageContext& context, const Frames& frames, const std::vector<std::size_t>& chosen,
                   const Ground& ground, const FrameProduct& icebergs, Stamps& stamps);

// frames.mp4 of those pictures, if ffmpeg is there, or a line that says why there is none.
void make_movie(const StageContext& context, const Frames& frames);

}  // namespace tidewater::postprocess
