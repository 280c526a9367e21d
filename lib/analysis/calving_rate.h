// How much calves per time.
//
// Test: tests/unit/analysis/calving_rate_test.cpp
#pragma once

#include <span>
#include <vector>

namespace tidewater::analysis {

// What calved within `window` (s, > 0) around each time, over the part of the window that the record covers.
//     time      s, strictly increasing
//     calved    volume that came off between the time before and this one; it counts as evenly spread between
//               both. The first is none: before the record nothing is known.
// The record's whole is kept: ∫ rate dt is Σ calved but for half a window at its ends. A record of one time
// has the rate 0.
std::vector<double> calving_rate(std::span<const double> time, std::span<const double> calved, double window);

}  // namespace tidewater::analysis
