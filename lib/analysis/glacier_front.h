// Where the glacier's front is, and how far behind it what comes off breaks.
//
// Rows are the strips along x, in 3D a particle spacing wide; in 2D there is one. A row's front is the
// greatest x of the glacier's particles between two heights, plus half a spacing.
//
// Test: tests/unit/analysis/glacier_front_test.cpp
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

struct FrontSettings {
    double spacing = 0.0;          // of the particles, m, > 0
    double low = 0.0, high = 0.0;  // z between which the front counts, m
};

struct FrontRows {
    std::int64_t first = 0;  // row of x[0]; row r holds r ≤ y/spacing < r + 1
    std::vector<double> x;   // m, of consecutive rows; NaN where a row has no front

    double at(std::int64_t row) const;  // NaN outside
    double median() const;              // of the rows that have a front; NaN if none has
};

// members: of the points (x, y, z per particle, m).
FrontRows find_front(std::span<const float> points, std::span<const std::uint32_t> members,
                     const FrontSettings& settings);

// How far behind the front, as it was before, an iceberg broke: the mean, over the lines along x a spacing in
// y and z that it fills, of the row's front less the iceberg's rear end; lines of rows without a front do not
// count. NaN if none does. Both fronts and ends are best taken where the ice was at rest.
double break_distance(std::span<const float> points, std::span<const std::uint32_t> iceberg,
                      const FrontRows& before, double spacing);

}  // namespace tidewater::analysis
