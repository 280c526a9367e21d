// The wave of ice that calves, as the laboratory's formulas have it in 3D and near the impact
// (analysis/radial_wave.h): what the main event (first_iceberg.h) sent into the water, taken as a slide.
//
//     mass m        of the main event's icebergs as they came off
//     speed v_s     |Σ m_i v_i| / Σ m_i of those icebergs, the greatest over time: their centre of mass, not
//     the
//                   fastest crumb
//     thickness s   the failed width, averaged over the height
//     width b       in 3D what the volume has beside height and failed width, in 2D 1
//     depth D       of the still water at the ice's front at the start, the depth of the impact
//
// The wave's amplitude in 2D is the highest leading crest at the gauges; its distance counts from that front.
// Only what hangs together when it comes off counts: ice that falls as rubble makes a wave that these numbers
// do not know of. The formulas are of blocks and slides in a laboratory; lib/analysis/README.md, Slides.
//
// Test: tests/pipeline/icebergs_test.sh
#pragma once

#include <optional>
#include <string>

#include "analysis/radial_wave.h"
#include "common/ground.h"
#include "common/stage.h"
#include "gauges.h"
#include "iceberg_tables.h"

namespace tidewater::postprocess {

struct CalvingWave {
    analysis::Slide slide{};
    double speed_time = analysis::none;  // s
    analysis::ImpulseProduct impulse{};
    double front = analysis::none;      // x, m
    double amplitude = analysis::none;  // m; NaN: no gauge saw a crest
    double amplitude_x = analysis::none;
};

// Nothing where no ice came off into water, or without gravity. The tables of the main event and the first
// iceberg must be written.
std::optional<CalvingWave> find_calving_wave(const StageContext& context, const IcebergTables& tables,
                                             const Waves& waves, const Ground& ground, double front);

// calving_wave.csv, one row, and waves_3d.csv.
void write_calving_wave(const StageContext& context, const CalvingWave& wave);

// The lines that the stage prints for people.
std::string describe(const CalvingWave& wave);

}  // namespace tidewater::postprocess
