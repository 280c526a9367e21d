// Fragments: ice that hangs together through intact ice.
//
// Two intact particles are connected if they are at most `reach` apart. With reach = usual_reach spacings,
// particles on a lattice of that spacing are connected along its axes and across its squares' diagonals, and
// so a crack separates where it is one particle wide along an axis, two at 45°: half a cell and one cell with
// 2 particles per cell and axis, while a crack that opens in the grid is at least a cell wide. Particles
// moved at random within their own shares of the cells stay connected; see fragments_test.cpp. Distances are
// those of the positions that are passed: at rest, or in a frame.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tidewater::analysis {

inline constexpr double usual_reach = 1.5;  // in particle spacings

struct Fragments {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t> label;  // of each particle: its fragment, or `none` for what is not intact
    std::vector<std::uint32_t> size;   // of each fragment: its number of particles
};

// Fragment 0 has the most particles; of equal ones the one with the lowest particle comes first.
//     points   m, (x, y, z) per particle, finite; y = 0 in 2D
//     intact   0 or 1 per particle
//     reach    m, > 0
Fragments label_fragments(std::span<const float> points, std::span<const std::uint8_t> intact, double reach);

}  // namespace tidewater::analysis
