// Particles inside level sets.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/level_set.h"

namespace tidewater::geometry {

enum class SeedPattern {
    lattice,    // in rows, moved by the jitter
    blue_noise  // in no rows, and apart: tiles of 16² cells in 2D, 6³ in 3D, all the same (blue_noise.h)
};

struct Seeding {
    double cell_size = 0.0;  // m
    int per_axis = 2;        // particles per cell and axis
    double jitter = 0.0;     // in [0, 1]: each is moved by up to jitter/2 of the spacing along each axis
    std::uint64_t seed = 1;
    std::uint64_t stream = 0;  // another one for each body; tiles do not depend on it, so that bodies fit
    SeedPattern pattern = SeedPattern::lattice;

    // Where a point of the lattice is put, once it is moved, before it is asked whether it lies inside, or no
    // more than a quarter of a spacing outside; empty: it stays. `margin` (m) is how far the lattice must
    // reach beyond the level set, on each side, to fill it.
    std::function<Point(const Point&)> place = {};
    double margin = 0.0;

    // Whether a point, placed and inside, is to be: leaves out what a level set is too coarse for. Empty: all
    // are. This and `place` are called in parallel, `place` twice for each point.
    std::function<bool(const Point&)> keep = {};
};

// The points of the lattice ((n + ½) cell_size/per_axis per axis) that lie inside, moved by the jitter or as
// the tile says, m; x slowest, z fastest. In 2D the plane y = 0. What moves them depends on the seed and the
// lattice point alone, so that any number of threads gives the same points.
//
// The level set's distances must not exceed the true ones: voxels beyond its band are taken to lie as far
// inside or outside as its background says. 36.5 million points of a box of ice take 2 to 5 s on two cores,
// and what they occupy (24 bytes each in 3D) and 6 MB more.
template <int D>
std::vector<Vector<D, double>> seed_points(const openvdb::FloatGrid& level_set, const Seeding& seeding);

}  // namespace tidewater::geometry
