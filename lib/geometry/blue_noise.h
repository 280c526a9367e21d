// Points that keep apart without lying in rows: a tile of them that repeats without a seam.
//
// One point per cell of a square lattice, anywhere in it to begin with. Then all are pushed apart together,
// step by step, each away from its neighbours nearer than 1.3 lattice edges, by (1 − d / 1.3) of each, and
// kept within its own cell, until the least distance is as asked. So every region of the lattice has exactly
// as many points as cells, and density varies over short ways only (hence the name); after the relaxed
// stratified samples of Mitchell 1987 and Balzer et al. 2009, with less effort and no claim to their spectra.
// Test: tests/unit/geometry/blue_noise_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/types.h"

namespace tidewater::geometry {

constexpr double least_distance = 0.75;  // between points of a tile, of the lattice's edge
constexpr double most_offset = 0.45;     // along each axis, so that none lies on a wall

template <int D>
struct BlueNoiseTile {
    long edge = 0;  // lattice points per axis, after which it repeats
    std::vector<Vector<D, double>>
        offset;  // of each from its lattice point, in lattice edges; last axis fastest
    const Vector<D, double>& at(const std::array<long, D>& lattice) const;  // any lattice point
};

// The same on any machine and number of threads. `edge` at least 5.
template <int D>
BlueNoiseTile<D> make_blue_noise_tile(long edge, std::uint64_t seed);

}  // namespace tidewater::geometry
