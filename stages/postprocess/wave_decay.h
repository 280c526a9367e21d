// How the leading wave falls with its distance from where it was made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/decay.h"
#include "core/provenance.h"
#include "gauges.h"
#include "scene/scene.h"
#include "wave_source.h"

namespace tidewater::postprocess {

struct WaveDecay {
    WavePath path;
    double depth = 0.0;  // D, of the scene's water, m
    struct Point {
        io::NamedPlace place;
        double distance =
            analysis::none;             // r from the source, m; of a gauge with a y, from the source's middle
        double crest = analysis::none;  // of the leading wave, m
    };
    std::vector<Point> points;  // the gauges on the path, by distance
    analysis::AmplitudeDecay fit;
};

// Of the gauges to which the wave runs, on the path.
WaveDecay find_decay(const Waves& waves, const WavePath& path, const scene::Scene& scene);

// decay.csv: per gauge x, y, distance r (m), distance_ratio r/D, crest (m) and that of the fit; fit of one
// row: decay_fit.csv.
void write_decay(const std::filesystem::path& folder, const WaveDecay& decay, const Provenance& provenance);

// The line that is printed; empty without gauges.
std::string describe(const WaveDecay& decay);

}  // namespace tidewater::postprocess
