// The table of effects: the one place that lists them all.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/effects/effect.h"

namespace tidewater::scene {

// In the order in which their keys are printed and their checks report.
std::span<const Effect* const> all_effects();

// The names that the key `effects` may hold, in the same order.
std::span<const std::string> known_effects();

}  // namespace tidewater::scene
