// Runs of the laboratory's icebergs (Heller et al. 2019; Wolper et al. 2021, Table 1 and Fig. 2): what
// postprocess found, beside what was measured.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/first_wave.h"
#include "analysis/radial_wave.h"
#include "core/provenance.h"

namespace tidewater::lab {

// What was measured, or follows from the block and the still water.
struct Experiment {
    std::string_view name;  // with which the labels of its runs begin
    double speed;           // v_s of the block's fastest part, m/s
    double energy;          // from release to equilibrium, J per m of width
    double farthest;        // r/D of the farthest gauge
};

inline constexpr std::array experiments{Experiment{"GF", 1.15, 537.0, 35.0},
                                        Experiment{"BF", 0.48, 66.0, 35.0},
                                        Experiment{"CS", 0.61, 38.0, 15.0}};

// nullptr if the label begins with the name of none.
const Experiment* experiment_of(std::string_view label);

struct Case {
    std::string label;  // "GF", "GF 0.04", or any other
    // As in tsunami.csv.
    double speed = analysis::none, froude = analysis::none, thickness_ratio = analysis::none,
           mass_ratio = analysis::none, impulse_product = analysis::none, amplitude = analysis::none,
           amplitude_time = analysis::none, amplitude_distance = analysis::none, celerity = analysis::none,
           linear_celerity = analysis::none, long_waves = analysis::none,
           long_waves_error = analysis::none,  // as in long_waves.csv, m/s
        long_wave_celerity = analysis::none, block_energy = analysis::none, water_energy = analysis::none,
           lost_energy = analysis::none, greatest_rise = analysis::none;
    std::vector<double> time, ratio, run;  // of the main way: since the greatest amplitude, s; amplitude
                                           // over it; distance from where it was, m

    double celerity_error() const;  // from √(gD), %
    // F, S and M as of a slide in water of 1 m; with the laboratory's speed where there is one and it is
    // asked for.
    analysis::Slide slide(bool measured_speed = false) const;
    double amplitude_3d(double distance_ratio, bool measured_speed = false) const;  // m
};

// A word of the command line, "LABEL=FOLDER" or "FOLDER", whose name then is the label: from the
// folder's postprocess/tsunami.csv and first_wave.csv. Throws InputError if one is missing or damaged.
Case read_case(const std::string& argument);

// lab.csv: a row per case.
void write_cases(const std::filesystem::path& path, const std::vector<Case>& cases,
                 const Provenance& provenance);

// lab.svg: the two panels of Fig. 2b with all cases, the waves in 3D over r/D, and the blocks' speeds against
// the laboratory's.
std::string draw_cases(const std::vector<Case>& cases, const Provenance& provenance);

// The table that is printed for people.
std::string describe(const std::vector<Case>& cases);

}  // namespace tidewater::lab
