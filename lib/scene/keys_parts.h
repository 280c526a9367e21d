// The keys that belong to no effect, and those of one that only later stages read.
#pragma once

#include <span>

#include "scene/keys.h"

namespace tidewater::scene {

std::span<const Key> scene_keys();
std::span<const Key> simulate_keys();
std::span<const Key> postprocess_keys();

}  // namespace tidewater::scene
