// How far a wave runs up the shore at the end of a tank, at one time, from the surface along it.
//
// The waterline is the outer end of the water that hangs together with the open water: from there outward
// the last place before a dry one (η is NaN). The open water begins at the outermost place whose still depth
// is at least `depth_of_open_water`; if that place is dry, at the next wet one inward. Drops and pools beyond
// a dry place do not count. Between the last wet place and the dry one beside it the surface goes on level
// until it meets the bed, so that the waterline is where the bed is as high as the last wet place's surface,
// but no farther than the dry place.
//
// Run-up R: the bed's height at the waterline above the still level; negative where the water has drawn back.
// With a wall instead of a shore (no dry place up to the end) it is η of the outermost place.
//
// A surface as read from particles (surface.h) needs about half a cell of water: thinner tongues are not
// seen.
//
// Test: tests/unit/analysis/run_up_test.cpp
#pragma once

#include <span>

#include "analysis/series.h"

namespace tidewater::analysis {

struct Waterline {
    double x = none;       // m
    double height = none;  // R, m
    bool at_wall = false;  // the water reaches the end
};

struct Shore {
    bool to_the_right = true;          // the end to which the wave runs: that of the greatest x, or the least
    double still_level = 0.0;          // z, m
    double depth_of_open_water = 0.0;  // m, > 0
};

// x: of the places, m, rising; bed: its height there, m; elevation: η, m, NaN where dry; all of one length.
// Without wet places, or without open water, all is NaN.
Waterline find_waterline(std::span<const double> x, std::span<const double> bed,
                         std::span<const double> elevation, const Shore& shore);

}  // namespace tidewater::analysis
