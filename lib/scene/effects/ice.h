// The effect "ice": one body of elastic ice, given as a box or as an outline in the x–z plane. Whether it
// breaks is the matter of the effect "fracture".
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/box.h"
#include "geometry/polygon.h"
#include "mpm/materials/ice.h"
#include "scene/enum_names.h"

namespace tidewater::scene {

struct Effect;
struct Reading;
struct Scene;

// What the lower side of the ice follows.
enum class IceBase { given, bed, floating };
template <>
inline constexpr std::array<std::string_view, 3> enum_names<IceBase>{"given", "bed", "floating"};

// The keys of [ice]; ice.cpp says what each means. After reading, size and corner are the box around the
// profile where there is one, and floating ice lies where it floats, with base = given.
struct Ice {
    std::vector<double> size;     // m
    std::vector<double> corner;   // m
    std::vector<double> profile;  // m
    std::string profile_file;
    IceBase base = IceBase::given;
    mpm::IceModel model;  // ice.density, .youngs_modulus, .poisson_ratio and .moduli
};

geometry::Box ice_box(const Scene& scene);

// The outline in the x–z plane: ice.profile, or the box where there is no profile.
geometry::Polygon ice_outline(const Scene& scene);

// The ice as the engine takes it: with or without fracture, and with ξ from the crack band where
// fracture.softening asks for it.
mpm::IceModel ice_model(const Scene& scene);

// Whether the scene has ice and its box in the tank can be relied on.
bool ice_box_known(const Reading& reading);

// The x of the front, m.
double front_of(const Scene& scene);

extern const Effect ice_effect;

}  // namespace tidewater::scene
