// The water's surface in every frame, on places a cell apart, and what is made of it over the run: profiles
// along the tank, the space-time diagram, and the waterline on the far shore.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/first_wave.h"
#include "analysis/run_up.h"
#include "common/ground.h"
#include "common/stage.h"
#include "frame_pass.h"
#include "io/surface_file.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

// Whether a scene has a block, water and gravity, and so a first wave.
bool makes_first_wave(const scene::Scene& scene);

// frames/surface_NNNN.h5 of every frame (io/surface_file.h; analysis/surface_field.h); none without water.
FrameProduct surface_product(const StageContext& context, const Ground& ground);

struct SurfaceProfiles {
    std::vector<double> x;                          // m, of the places: a cell apart, at mid-width in 3D
    std::vector<float> bed;                         // m, its height there
    std::vector<analysis::SurfaceProfile> of_time;  // one per frame
};

// The highest waterline on the far shore, or elevation at the far wall, in one frame.
struct FarEnd {
    double time = 0.0, y = 0.0;  // s; m, of the place across the tank
    analysis::Waterline waterline;
};

struct Surfaces {
    SurfaceProfiles profiles;  // along the middle of the tank
    std::vector<FarEnd> far_end;
    double front = analysis::none;  // x where the open water begins at the start, m; NaN: at the left wall
};

// From the files of all frames, one in memory at a time; empty without water. The far end is that to which
// main_wave_path runs.
Surfaces gather_surfaces(const StageContext& context, const Frames& frames);

// The middle row, or the mean of the two beside the middle where their number is even.
std::vector<double> middle_line(const io::Surface& surface);

}  // namespace tidewater::postprocess
