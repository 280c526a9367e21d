// The search for the first detachment that calving.h describes. Test: tests/unit/analysis/calving_test.cpp
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/calving.h"

namespace tidewater::analysis {

struct DetachmentSettings {
    double end_of_rear = 0.0;      // greatest x of the rear, m
    double reach = 0.0;            // of a connection, m
    double smallest_volume = 0.0;  // of an iceberg, m³ (2D: m²)
};

struct Detachment {
    float time;              // s
    std::uint32_t particle;  // one of the iceberg's
};

// Of several icebergs that come off at the first time, the largest. `times` are those of failure_time, but
// infinite where the ice never fails or is the rear's.
std::optional<Detachment> find_detachment(const IceAtRest& ice, std::span<const float> times,
                                          const DetachmentSettings& settings);

}  // namespace tidewater::analysis
