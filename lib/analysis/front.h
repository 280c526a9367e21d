// The front of water that runs over a dry bed.
#pragma once

#include <cstdint>
#include <span>

namespace tidewater::analysis {

// x (m) up to which water hangs together: from its least x on, no two neighbours along x are more than `gap`
// (m) apart; drops that fly ahead do not count. NaN without water.
//     points     (x, y, z) of each particle, m
//     material   numbers of core's Material, as many; only water counts
// Test: tests/unit/analysis/front_test.cpp.
double water_front(std::span<const float> points, std::span<const std::uint8_t> material, double gap);

}  // namespace tidewater::analysis
