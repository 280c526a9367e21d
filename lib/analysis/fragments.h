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

// Joins the fragments that hold a particle of `rear` (0 or 1 per particle), for what is connected to the rear
// belongs together whatever failed there (calving.h), into the one that comes first; the others are left
// with size 0. Returns its label, `none` without such a particle.
std::uint32_t join_fragments(std::span<const std::uint8_t> rear, Fragments& fragments);

// Takes out the fragments of less than `least` in volume: their particles are in none, their size is 0.
// `kept` stays whatever its volume.
void drop_crumbs(std::span<const float> volume, double least, std::uint32_t kept, Fragments& fragments);

// The particles of each fragment, rising: those of fragment f are particles[first[f]] to
// particles[first[f + 1] - 1]. Not those of `left_out`.
struct FragmentMembers {
    std::vector<std::uint32_t> particles, first;

    std::span<const std::uint32_t> of(std::uint32_t fragment) const {
        return {particles.begin() + first[fragment], particles.begin() + first[fragment + 1]};
    }
};
FragmentMembers collect_members(const Fragments& fragments, std::uint32_t left_out = Fragments::none);

}  // namespace tidewater::analysis
