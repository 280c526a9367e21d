// Icebergs followed through time by what they consist of.
//
// A frame says of each intact particle of ice, by its lasting id, which fragment (fragments.h) it is in. The
// overlap of an iceberg of the frame before with a fragment is the volume of the particles that they share.
// Pairs are taken by falling overlap, equal ones by their lowest common particle id: where neither has a
// partner yet, the fragment goes on as that iceberg. So of an iceberg that splits the largest piece keeps the
// id, and of icebergs that merge the fragment takes that of the one that it has most of. Then
//     a fragment without a partner is a new iceberg; if it overlaps one of the frame before, it split from
//     the one with the largest overlap, else its parent is `none`;
//     an iceberg without a partner that overlaps a fragment has merged into the one that has most of it; one
//     that overlaps none is gone. Their ids never come back.
// Ids count from 0, new ones of a frame by their lowest particle id. What fails in one frame and is intact
// again in a later one is new there. Nothing depends on the order of particles or on the labels' numbers.
//
// Test: tests/unit/analysis/iceberg_track_test.cpp
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tidewater::analysis {

struct IcebergEvent {
    enum class Kind { split, merge, gone };
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    double time = 0.0;  // s, of the frame
    Kind kind = Kind::split;
    std::uint32_t iceberg = none;  // that is new, has merged into another or is gone
    std::uint32_t other = none;    // from which it split, into which it merged; none: neither
};

// Flat arrays, one entry per particle of ice; id different for each particle.
struct FragmentFrame {
    double time = 0.0;                     // s, later than the frame before
    std::span<const std::uint64_t> id;     // lasting
    std::span<const std::uint32_t> label;  // from 0 on, or Fragments::none for what is not intact
    std::span<const float> volume;         // at rest, m³ (2D: m²)
};

// What is known between two frames.
struct IcebergTracks {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> members;  // particle id, iceberg; by particle id
    std::uint32_t count = 0;                                       // of ids given so far
    std::vector<IcebergEvent> events;                              // by time; in a frame by `iceberg`
};

// Goes on to the next frame; returns the iceberg of each label (none: a label without a particle).
std::vector<std::uint32_t> follow_icebergs(const FragmentFrame& frame, IcebergTracks& tracks);

// One iceberg's shape and motion, from its own particles.
struct IcebergState {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  // of its volume, m
    double volume = 0.0;                                 // at rest, m³ (2D: m²)
    // The oriented box: edges along the principal axes of the particles' covariance, from the least to the
    // greatest centre plus a particle spacing; length ≥ width ≥ height. In 2D the width is 0. Blocks whose
    // edges are nearly equal have no such axes: the box may lie at any angle.
    double length = 0.0, width = 0.0, height = 0.0;      // m
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // unit vectors of the three edges, as columns
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s
    // ω = I⁻¹ L, both about the centroid and of the particles as points, rad/s: exact for a rigid motion.
    // Of one particle, or in 3D of a row of them, it is 0 where I is singular. In 2D ω is along y.
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
    double draft = 0.0, freeboard = 0.0;  // m, of its lowest below and its highest above the still level
};

struct IcebergParticles {
    std::span<const float> points;    // m, (x, y, z) per particle; y = 0 in 2D
    std::span<const float> velocity;  // m/s, likewise
    std::span<const float> volume;    // at rest, m³ (2D: m²)
};

// members: of the particles, at least one; summed in this order. spacing: of the particles, m; dimension: 2
// or 3; still_level: z, m.
IcebergState describe_iceberg(const IcebergParticles& particles, std::span<const std::uint32_t> members,
                              int dimension, double spacing, double still_level);

}  // namespace tidewater::analysis
