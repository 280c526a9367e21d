// How a piece of ground, the bed or the shelf's top, acts on ice and water (mpm/boundaries/ground.h,
// mpm/boundaries/drag.h). Its keys are in ground_keys.h.
#pragma once

#include <optional>

#include "mpm/boundaries/wall.h"

namespace tidewater::scene {

// Units are those of glaciology: years (a) of 365.25 days. Each key's help says what it means.
struct Ground {
    double friction = 0.0;       // 0 … ∞
    double sliding_speed = 0.0;  // m/a
    double weertman = 0.0;       // Pa (a/m)^(1/sliding_exponent)
    double sliding_exponent = 3.0;
    double pore_pressure = 0.0;         // 0 … 1
    double drag = 0.0;                  // 0 … ∞
    double manning = 0.0;               // s/m^(1/3)
    std::optional<mpm::WallRule> wall;  // the retired key that said all this in one word
};

inline constexpr double seconds_per_year = 365.25 * 86400.0;

}  // namespace tidewater::scene
