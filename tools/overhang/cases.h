// Runs of ice that overhangs: what came off, against what beam theory says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/beam.h"
#include "analysis/calving.h"
#include "core/provenance.h"

namespace tidewater::overhang {

struct Case {
    std::string name;  // of the run's folder
    analysis::Overhang overhang;
    double strength = 0.0;           // βp0, the table's, Pa
    double uniaxial_strength = 0.0;  // of the yield surface in the scene's dimension, Pa

    // Measured; NaN: nothing came off by end_time.
    double time = analysis::none;          // s
    double length_ratio = analysis::none;  // Li/H
    double start_height = analysis::none;  // of the crack, share of the height
    double end_time = 0.0;                 // s

    double depth_ratio() const { return overhang.depth / overhang.height; }
    bool came_off() const;  // with a length
    // Li/H.
    double eq1() const { return analysis::paper_length_ratio(overhang, strength); }
    double beam() const { return analysis::beam_length_ratio(overhang, strength); }
    double uniaxial_beam() const { return analysis::beam_length_ratio(overhang, uniaxial_strength); }
    // Whether both have the same curves of theory.
    bool alike(const Case& other) const;
};

// From <run>/postprocess/icebergs.csv and the scene.toml beside it. Throws InputError if one is missing or
// damaged, or has no ice; SceneError if the scene is not one of this version.
Case read_case(const std::filesystem::path& run);

// Those that are alike together, by increasing height and strength; then by D/H, then by name.
void sort_cases(std::vector<Case>& cases);

// overhang.csv: a row per case, with the difference of the measured length to each theory in %.
void write_cases(const std::filesystem::path& path, const std::vector<Case>& cases,
                 const Provenance& provenance);

// overhang.svg: Li/H over D/H, a panel for all cases that are alike.
std::string draw_cases(const std::vector<Case>& cases, const Provenance& provenance);

}  // namespace tidewater::overhang
