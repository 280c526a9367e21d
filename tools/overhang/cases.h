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

    // Measured; NaN: nothing came off, or cracked, by end_time.
    double time = analysis::none;                // s
    double length_ratio = analysis::none;        // Li/H, of the iceberg
    double start_height = analysis::none;        // of the crack that frees it, share of the height
    double crack_time = analysis::none;          // s, the first crack's
    double crack_start_height = analysis::none;  // share of the height
    double crack_position = analysis::none;      // behind the front, over H
    double end_time = 0.0;                       // s
    // L/H, the ice's length beyond the shelf's edge at `time`, as the plane that pushes it has moved by then:
    // the length of the cantilever from its support, of which eq. 10 of the paper speaks. NaN also in scenes
    // without a shelf or a push.
    double overhang_ratio = analysis::none;

    double depth_ratio() const { return overhang.depth / overhang.height; }
    bool came_off() const;  // with a length
    // Li/H or L/H.
    double eq1() const { return analysis::paper_length_ratio(overhang, strength); }
    double eq1_submerged() const {  // see beam.h
        return analysis::paper_length_ratio(analysis::submerged(overhang), strength);
    }
    double beam() const { return analysis::beam_length_ratio(overhang, strength); }
    double uniaxial_beam() const { return analysis::beam_length_ratio(overhang, uniaxial_strength); }
    // Whether both have the same curves of theory.
    bool alike(const Case& other) const;
};

// From <run>/postprocess/first_iceberg.csv and the scene.toml beside it. Throws InputError if one is missing or
// damaged, or has no ice; SceneError if the scene is not one of this version.
Case read_case(const std::filesystem::path& run);

// Those that are alike together, by increasing height and strength; then by D/H, then by name.
void sort_cases(std::vector<Case>& cases);

// overhang.csv: a row per case, with the differences of both measured lengths to each theory in %.
void write_cases(const std::filesystem::path& path, const std::vector<Case>& cases,
                 const Provenance& provenance);

// overhang.svg: both lengths over D/H, a panel for all cases that are alike.
std::string draw_cases(const std::vector<Case>& cases, const Provenance& provenance);

}  // namespace tidewater::overhang
