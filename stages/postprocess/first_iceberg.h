// How the ice broke, measured where it was at rest: the first crack and the first iceberg, from the times at
// which particles failed, and the main event, from the icebergs that were followed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/calving.h"
#include "analysis/first_crack.h"
#include "common/stage.h"
#include "frame_pass.h"
#include "frames.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

// What first_iceberg.csv holds, in one row; NaN where there was none.
struct FirstIceberg {
    analysis::FirstCrack crack{analysis::none, analysis::none, analysis::none, analysis::none};
    analysis::Calving calving;
    double end_time = 0.0;               // of the last frame, s
    double failed_share = 0.0;           // of the ice's volume, at the end
    double ice_height = analysis::none;  // of the ice at rest, m
};

// What main_event.csv holds, in one row: the frame in which the most ice came off the glacier.
struct MainEvent {
    double frame = analysis::none;        // its number; NaN: nothing came off
    double time_before = analysis::none;  // s, of the frame before
    double icebergs = 0.0;                // that came off in it
    double largest = analysis::none;      // iceberg, the largest of them
    analysis::Calving calving;            // of all of them; time is the frame's
};

// Of the last frame: first_iceberg.csv where particles have failure times, and main_event.csv. No files of
// a scene without ice. Particles are matched with the first frame's, where the ice is at rest, by their ids;
// one that is no longer there counts as intact. Comes after icebergs_product; `frames` must outlive it.
FrameProduct first_iceberg_product(const StageContext& context, const Frames& frames);

// Nothing if the file is not there. Throws InputError.
std::optional<FirstIceberg> read_first_iceberg(const std::filesystem::path& folder);
std::optional<MainEvent> read_main_event(const std::filesystem::path& folder);

// The lines that the stage prints for people.
std::string describe(const FirstIceberg& first, int dimension);
std::string describe(const MainEvent& event, int dimension);

// "1234 m³", "1234 m² per m of width"
std::string volume_text(double volume, int dimension);

}  // namespace tidewater::postprocess
