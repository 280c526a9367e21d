// The water surface on a lattice of places a cell apart, from a cloud of particles: the method of surface.h
// for many places at once.
//
// Places are at the middle of the cells, x_i = (i + ½) Δx and y_j = (j + ½) Δx, i < along, j < across; in 2D
// across = 1 and y is not read. Particles of water are first sorted by columns of cells, of which a place
// reads its own and those around it; places are then taken in parallel, each in the same order of particles,
// so that the result does not depend on the number of threads.
//
// There is no elevation (NaN) where no water lies on the bed, and where ice or a block covers the place:
// where within a cell of it, in x and in y, lie solids of more than a quarter of a cell on average over that
// square, at any height, for the surface over a block, or beside the ice that floats in it, is no wave's.
// Single crumbs of ice do not cover a place.
//
// Test: tests/unit/analysis/surface_field_test.cpp, against surface_elevation.
#pragma once

#include <span>
#include <vector>

#include "analysis/surface.h"

namespace tidewater::analysis {

struct Lattice {
    int along = 0, across = 1;  // number of places in x and in y
    double spacing = 0.0;       // Δx, m

    std::size_t count() const { return static_cast<std::size_t>(along) * static_cast<std::size_t>(across); }
    double x(int i) const { return (i + 0.5) * spacing; }
    double y(int j) const { return (j + 0.5) * spacing; }
};

// The whole cells of a tank.
Lattice cell_lattice(const Tank& tank);

// η, m, at place (i, j) as entry i + along · j. bed: its height, m, in the same order. Memory: 16 bytes per
// particle of water and 12 per place.
std::vector<float> surface_field(const ParticleCloud& cloud, const Tank& tank, std::span<const float> bed);

}  // namespace tidewater::analysis
