// The parts of the table of keys, in the order in which they are printed.
#pragma once

#include <array>
#include <span>

#include "scene/keys.h"

namespace tidewater::scene {

inline constexpr Range positive{.least = 0.0, .open = true};
inline constexpr Range not_negative{.least = 0.0};

std::span<const Key> tank_keys();
std::span<const Key> glacier_keys();
std::span<const Key> run_keys();
std::span<const Key> postprocess_keys();

}  // namespace tidewater::scene
