// The crack that parted an iceberg from what is behind it, by what lay on either side of it; rows, lengths
// and the failure plane are told in calving.h.
//
// Test: tests/unit/analysis/failure_surface_test.cpp
#pragma once

#include <cstdint>
#include <span>

#include "analysis/calving.h"

namespace tidewater::analysis {

enum class Side : std::uint8_t { neither, iceberg, rear };

// sides: of each particle, just after the detachment at `time` (s). Of the ice, failure_time may be empty;
// then, and where no particle between both sides has failed by `time`, the crack's start is not known. Of
// the settings, dimension and spacing count.
Calving measure_calving(const IceAtRest& ice, std::span<const Side> sides, double time,
                        const CalvingSettings& settings);

}  // namespace tidewater::analysis
