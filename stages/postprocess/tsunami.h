// The wave that a rigid block makes, against theory and, in 3D, as the laboratory's formulas have it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/first_wave.h"
#include "analysis/radial_wave.h"
#include "bodies.h"
#include "core/provenance.h"
#include "energy_split.h"
#include "scene/scene.h"
#include "surface.h"

namespace tidewater::postprocess {

// One way that the first wave runs.
struct WaveWay {
    double source = 0.0, wall = 0.0;  // x, m
    analysis::FirstWave wave;

    // m/s; of linear_crest_distance over the times of which wave.celerity is the slope.
    double linear_celerity = analysis::none;

    bool to_the_right() const { return wall > source; }
};

struct Tsunami {
    Body block;                   // the heaviest
    std::size_t block_count = 0;  // that the run has
    double speed_time = 0.0;      // when the block's fastest point was fastest, s
    analysis::Slide slide;
    analysis::ImpulseProduct impulse;
    std::vector<WaveWay> ways;                   // away from the wall that the block is at, else both ways
    double long_wave_celerity = analysis::none;  // √(gD), m/s
    EnergySplit energy;
    int dimension = 2;

    // Of the ways in which a wave ran far enough for a celerity the one in which it becomes highest; if there
    // is none, of all (what piles up beside the block and stays is higher than a low wave). nullptr if no
    // wave was found.
    const WaveWay* main_way() const;
};

// As in the laboratory, distances count from the wall that the block is within a cell of, else from the
// block's centre at the start. There must be a body.
Tsunami find_tsunami(const std::vector<Body>& bodies, const SurfaceProfiles& profiles, EnergySplit energy,
                     const scene::Scene& scene);

// first_wave.csv: the leading crest at each frame's time, both ways behind each other.
void write_first_wave(const std::filesystem::path& path, const Tsunami& tsunami,
                      const Provenance& provenance);

// waves_3d.csv: the main way's greatest amplitude, and the one at that distance, in 3D at r/D from 2 to 35;
// and the impulse product's height there.
void write_waves_3d(const std::filesystem::path& path, const Tsunami& tsunami, const Provenance& provenance);

// tsunami.csv: one row, what is printed.
void write_tsunami(const std::filesystem::path& path, const Tsunami& tsunami, const Provenance& provenance);

// The lines that the stage prints for people.
std::string describe(const Tsunami& tsunami);

}  // namespace tidewater::postprocess
