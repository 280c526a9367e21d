// The effect "bed": ground, given by the corners of its profile or by an elevation model (effect "dem").
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/profile.h"
#include "scene/enum_names.h"
#include "scene/ground.h"

namespace tidewater::scene {

struct Effect;
struct Reading;
struct Scene;

// The shape of the ground between two corners.
enum class BedShape { straight, smooth };
template <>
inline constexpr std::array<std::string_view, 2> enum_names<BedShape>{"straight", "smooth"};

// The keys of [bed]; bed.cpp says what each means.
struct Bed {
    std::vector<double> profile;  // m
    std::string profile_file;
    BedShape shape = BedShape::straight;
    Ground ground;
};

// The ground of a scene whose bed has a profile.
geometry::Profile bed_profile(const Scene& scene);

// Whether the scene has a bed with a profile that is in order by itself.
bool bed_profile_known(const Reading& reading);

extern const Effect bed_effect;

}  // namespace tidewater::scene
