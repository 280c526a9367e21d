// The effect "fracture": ice softens and breaks, by the plasticity of mpm/materials/ice.h.
#pragma once

#include <array>
#include <string_view>

#include "scene/enum_names.h"

namespace tidewater::scene {

struct Effect;

// How ξ follows from the keys.
enum class Softening { paper, crack_band };
template <>
inline constexpr std::array<std::string_view, 2> enum_names<Softening>{"paper", "crack_band"};

enum class HardeningLimit { start, none };
template <>
inline constexpr std::array<std::string_view, 2> enum_names<HardeningLimit>{"start", "none"};

// The keys of [fracture]; fracture.cpp says what each means. The keys fracture.strength, .beta, .friction,
// .hardening and .shear_return are members of Ice::model.
struct Fracture {
    Softening softening = Softening::paper;
    double energy = 0.0;  // J/m²
    HardeningLimit hardening_limit = HardeningLimit::start;
};

extern const Effect fracture_effect;

}  // namespace tidewater::scene
