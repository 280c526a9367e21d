// The ice of a frame in pieces: the glacier and the icebergs, found as fragments of intact ice
// (iceberg_frames.h says what is intact and what the glacier).
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "analysis/fragments.h"
#include "core/types.h"
#include "io/snapshot.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

inline bool is_ice(const io::Snapshot& snapshot, std::size_t p) {
    return static_cast<Material>(snapshot.material[p]) == Material::ice;
}

// The particles' ids; where the file has none, `places` is made to hold their places in it.
std::span<const std::uint32_t> particle_ids(const io::Snapshot& snapshot, std::vector<std::uint32_t>& places);

// The places of the ice in a snapshot whose particles have these ids, in the order of ids.
std::vector<std::uint32_t> ice_by_id(const io::Snapshot& snapshot, std::span<const std::uint32_t> ids);

// Least volume of an iceberg that is followed, m³ (2D: m²).
double least_iceberg(const scene::Scene& scene);

// What the first frame tells of the ice.
struct Start {
    std::vector<bool> rear;  // by particle id; those beyond are not the rear's
    std::vector<std::pair<std::uint32_t, float>>
        weak;                       // id and damage of what was damaged but had not failed
    std::vector<std::uint32_t> id;  // of the ice, rising
    std::vector<float> points;      // of each where it is at rest, (x, y, z), m
    double front_low = -INFINITY, front_high = INFINITY;  // between which z the front is measured, m
};

Start read_start(const io::Snapshot& first, const scene::Scene& scene);

// The glacier and the icebergs of a frame, without crumbs.
struct Pieces {
    analysis::Fragments fragments;
    std::uint32_t glacier = analysis::Fragments::none;  // its label
    double failed_volume = 0.0;  // of the ice that is not intact, and of crumbs, m³ (2D: m²)
    double crumb_volume = 0.0;
};

// ids: of the particles.
Pieces find_pieces(const io::Snapshot& snapshot, std::span<const std::uint32_t> ids, const Start& start,
                   const scene::Scene& scene);

}  // namespace tidewater::postprocess
