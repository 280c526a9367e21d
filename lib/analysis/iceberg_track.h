// Icebergs followed through time by what they consist of.
//
// A frame says of each particle, by its lasting id, which fragment (fragments.h) it is in. The overlap of an
// iceberg of the frame before with a fragment is the volume of the particles that they share. Pairs are taken
// by falling overlap, equal ones by their lowest common particle id: where neither has a partner yet, the
// fragment goes on as that iceberg. So of an iceberg that splits the largest piece keeps the id, and of
// icebergs that merge the fragment takes that of the one that it has most of. Only the glacier, iceberg 0, is
// told from outside: the fragment that is named as such goes on as iceberg 0, even if most of what it was
// has left it, and no other does. Then
//     a fragment without a partner is a new iceberg; if it overlaps one of the frame before, it split from
//     the one with the largest overlap, else its parent is `none`;
//     an iceberg without a partner that overlaps a fragment has merged into the one that has most of it; one
//     that overlaps none is gone. Their ids never come back.
// Ids count from 1, new ones of a frame by their lowest particle id. What fails in one frame and is intact
// again in a later one is new there. Nothing depends on the order of particles or on the labels' numbers.
//
// Memory: 8 bytes per intact particle between frames, 20 while at work.
//
// Test: tests/unit/analysis/iceberg_track_test.cpp
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tidewater::analysis {

inline constexpr std::uint32_t glacier_id = 0;

struct IcebergEvent {
    enum class Kind : std::uint8_t { split, merge, gone };
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    double time = 0.0;  // s, of the frame
    Kind kind = Kind::split;
    std::uint32_t iceberg = none;  // that is new, has merged into another or is gone
    std::uint32_t other = none;    // from which it split, into which it merged; none: neither
    double volume = 0.0;           // at rest, m³ (2D: m²): of the new iceberg; of what merged; gone: 0

    bool calved() const { return kind == Kind::split && other == glacier_id; }
};

// Flat arrays, one entry per particle; id different for each.
struct FragmentFrame {
    double time = 0.0;                           // s, later than the frame before
    std::span<const std::uint32_t> id;           // lasting
    std::span<const std::uint32_t> label;        // from 0 on, or Fragments::none for what is in no fragment
    std::span<const float> volume;               // at rest, m³ (2D: m²)
    std::uint32_t glacier = IcebergEvent::none;  // the label that is the glacier; none: there is none
};

struct IcebergMember {
    std::uint32_t particle, iceberg;  // ids

    bool operator==(const IcebergMember&) const = default;
};

// What is known between two frames.
struct IcebergTracks {
    std::vector<IcebergMember> members;  // by particle
    std::uint32_t count = 1;             // of ids given so far, the glacier's among them
    std::vector<IcebergEvent> events;    // of the last frame: merge and gone, then split, each by `iceberg`
};

// Goes on to the next frame; returns the iceberg of each label (none: a label without a particle).
std::vector<std::uint32_t> follow_icebergs(const FragmentFrame& frame, IcebergTracks& tracks);

}  // namespace tidewater::analysis
