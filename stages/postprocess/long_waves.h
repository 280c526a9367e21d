// How fast long waves run away from a block, from the gauges' records and linear dispersion
// (lib/analysis/celerity_fit.h): also where no crest of the first wave can be followed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/celerity_fit.h"
#include "core/provenance.h"
#include "gauges.h"
#include "scene/scene.h"
#include "tsunami.h"

namespace tidewater::postprocess {

struct LongWaves {
    bool to_the_right = true;
    double end = analysis::none;  // s; where the records end for this, so that they hold no reflection
    analysis::CelerityFit fit;
};

// One per way of the wave. Counted are records of the run itself, of gauges that are told by x alone and
// stand 2 D from the way's source or more and at most three quarters of the way to its wall; until a wave of
// √(gD) that left the source at t = 0 is back at the farthest of them.
std::vector<LongWaves> fit_long_waves(const std::vector<GaugeRecord>& records,
                                      const std::vector<WaveWay>& ways, double depth, double gravity);

// long_waves.csv: a row per way: direction (1: to the right, -1), pairs of gauges, end (s), celerity, error
// (m/s), explained, long_wave_celerity √(gD) (m/s), error_percent, the celerity's difference to it.
void write_long_waves(const std::filesystem::path& path, const std::vector<LongWaves>& waves,
                      double long_wave_celerity, const Provenance& provenance);

// A line per way that has a celerity.
std::string describe(const std::vector<LongWaves>& waves, double long_wave_celerity);

}  // namespace tidewater::postprocess
