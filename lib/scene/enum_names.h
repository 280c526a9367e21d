// The names of enums in scene files.
#pragma once

#include <array>
#include <string_view>

#include "mpm/boundaries/wall.h"

namespace tidewater::scene {

// The names of an enum's values in the order of their numbers. Every enum that a key holds specialises it as
// a std::array<std::string_view, …>: beside the enum, or for an enum of the engine in the file of the keys
// that hold it.
template <class Enum>
inline constexpr bool enum_names = false;

// What a wall does: one of the tank, the shelf or the bed.
template <>
inline constexpr std::array<std::string_view, 3> enum_names<mpm::WallRule>{"slip", "stick", "separate"};

}  // namespace tidewater::scene
