// Gauges of both kinds, what they saw, and the table of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/wave.h"
#include "common/ground.h"
#include "common/stage.h"
#include "core/provenance.h"
#include "frame_pass.h"
#include "io/places.h"
#include "scene/scene.h"
#include "statistics.h"

namespace tidewater::postprocess {

struct GaugeRecord {
    io::NamedPlace place;           // x, and y if the gauge is told by both
    std::string source;             // "run": written while simulating; "snapshots": read from the frames
    std::vector<double> time;       // s
    std::vector<double> elevation;  // η, m; NaN where dry
};

// The records of simulate/gauges.csv. Throws InputError if it is missing or damaged.
std::vector<GaugeRecord> read_run_gauges(const std::filesystem::path& path);

// The elevations at postprocess.gauges in every frame, frames/gauges_NNNN.csv, and the records gathered from
// them; no files and no records without gauges.
FrameProduct gauges_product(const StageContext& context, const Ground& ground);
std::vector<GaugeRecord> gather_gauges(const StageContext& context, const Frames& frames);

// gauges.nc (io/wave_records_nc.h) of simulate's gauges, or of those from snapshots where there are none of
// simulate's; gauges_snapshots.nc of the latter where there are both, for they have times of their own.
void write_gauges_nc(const std::filesystem::path& folder, const std::vector<GaugeRecord>& records,
                     const scene::Scene& scene, const Provenance& provenance);

// Writes records of equal times as a table with the columns time, x=<x> or x=<x> y=<y>, ...
void write_gauges(const std::filesystem::path& path, const std::vector<GaugeRecord>& records,
                  const Provenance& provenance);

struct Waves {
    std::vector<GaugeRecord> records;            // in the order of x; those with a y behind, by y
    std::vector<analysis::GaugeWave> gauges;     // of each record
    std::vector<GaugeStatistics> statistics;     // likewise
    std::vector<analysis::Celerity> to_next;     // from each gauge to the next, none to one of another y or
                                                 // on the other side of the block
    analysis::Celerity overall;                  // of the gauges to the right of the block
    double long_wave_celerity = analysis::none;  // √(gD), m/s
};

// Without the effect "water" or without gravity the records are kept and everything else is empty or NaN.
Waves analyse(std::vector<GaugeRecord> records, const scene::Scene& scene, const Ground& ground);

// waves.csv: a row per gauge, in the order of x, with the members of GaugeWave, then the celerity from its
// leading crest to that of the next gauge, √(gD) and their difference in %; the same from arrivals; then what
// statistics.h says. The last row, of source "all", has the celerities fitted to all gauges.
void write_waves(const std::filesystem::path& path, const Waves& waves, const Provenance& provenance);

// The table that the stage prints for people.
std::string describe(const Waves& waves);

}  // namespace tidewater::postprocess
