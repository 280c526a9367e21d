// The parts of the table of keys that do not come from an effect.
#pragma once

#include <span>

#include "scene/keys.h"

namespace tidewater::scene {

std::span<const Key> scene_keys();
std::span<const Key> simulate_keys();
std::span<const Key> postprocess_keys();

}  // namespace tidewater::scene
