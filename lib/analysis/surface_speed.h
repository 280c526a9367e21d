// How fast the water at its surface is, on places a cell apart.
#pragma once

#include <span>
#include <vector>

#include "analysis/surface.h"

namespace tidewater::analysis {

// Places with equal distances Δx in x, and in y if there is more than one row.
struct PlaceGrid {
    std::span<const double> x, y;  // m, rising
    std::span<const float> level;  // z of the surface, at (x[i], y[j]) as entry i + x.size() j; NaN: none
    double cell_size = 0.0;        // Δx > 0, m
};

// |v|, m/s, of the mean velocity v of the water particles that are nearest to each place in plan and at most
// Δx above or below its surface, weighed with their volumes; NaN where there are none or no surface. One pass
// over the particles, in their order. `velocity` holds (x, y, z) per particle, m/s.
// Test: tests/unit/analysis/surface_speed_test.cpp
std::vector<float> surface_speed(const ParticleCloud& cloud, std::span<const float> velocity,
                                 const PlaceGrid& places);

}  // namespace tidewater::analysis
