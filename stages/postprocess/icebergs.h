// What broke in the ice and came off it: the first crack and the first iceberg, from the times at which
// particles failed, and the fragments that there are in the end.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/calving.h"
#include "analysis/first_crack.h"
#include "core/provenance.h"
#include "frames.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

struct Fragment {
    double volume = 0.0;                  // at rest, m³ (2D: m²)
    std::array<double, 3> center{};       // of its volume, m
    std::array<double, 3> low{}, high{};  // its particles lie between these corners, m
};

struct Icebergs {
    std::optional<analysis::FirstCrack> crack;
    std::optional<analysis::Calving> first;
    std::vector<Fragment> fragments;  // of intact ice in the last frame, none smaller than smallest
    double end_time = 0.0;            // of the last frame, s
    double failed_share = 0.0;        // of the ice's volume, at the end
    double smallest = 0.0;            // volume of an iceberg, m³ (2D: m²)
    double height = 0.0;              // of the ice at rest, m
    int dimension = 2;
};

// Nothing if the last frame has no failure times or no ice. Particles are matched with the first frame's,
// where the ice is at rest, by their ids; one that is no longer there counts as intact. Throws InputError.
std::optional<Icebergs> find_icebergs(const Frames& frames, const scene::Scene& scene);

// icebergs.csv: one row with the first detachment and the first crack, nan where there was none.
void write_icebergs(const std::filesystem::path& path, const Icebergs& icebergs, double ice_density,
                    const Provenance& provenance);

// fragments.csv: a row per fragment, the largest first.
void write_fragments(const std::filesystem::path& path, const Icebergs& icebergs,
                     const Provenance& provenance);

// The lines that the stage prints for people.
std::string describe(const Icebergs& icebergs);

}  // namespace tidewater::postprocess
