// Particles inside level sets.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/level_set.h"

namespace tidewater::geometry {

struct Seeding {
    double cell_size = 0.0;  // m
    int per_axis = 2;        // particles per cell and axis
    double jitter = 0.0;     // in [0, 1]: each is moved by up to jitter/2 of the spacing along each axis
    std::uint64_t seed = 1;
    std::uint64_t stream = 0;  // another one for each body

    // Where a point of the lattice is put, jitter included, before it is asked whether it lies inside, or no
    // more than a quarter of a spacing outside; empty: it stays. Called in parallel. `margin` (m) is how far
    // the lattice must reach beyond the level set, on each side, to fill it.
    std::function<Point(const Point&)> place = {};
    double margin = 0.0;
};

// The points of the lattice ((n + ½) cell_size/per_axis per axis) that lie inside, moved by the jitter, m; x
// slowest, z fastest. In 2D the plane y = 0. The jitter depends on the seed and the lattice point alone, so
// that any number of threads gives the same points.
template <int D>
std::vector<Vector<D, double>> seed_points(const openvdb::FloatGrid& level_set, const Seeding& seeding);

}  // namespace tidewater::geometry
