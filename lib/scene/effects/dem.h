// The effect "dem": the ground, the ice's surface or both come from elevation models.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scene/enum_names.h"

namespace tidewater::scene {

struct Effect;

// What becomes of the holes of an elevation model.
enum class Nodata { refuse, fill };
template <>
inline constexpr std::array<std::string_view, 2> enum_names<Nodata>{"refuse", "fill"};

// The keys of [dem]; dem.cpp says what each means.
struct Dem {
    std::string bed;
    std::string surface;
    std::vector<double> origin;  // m, (east, north)
    double azimuth = 90.0;       // degrees
    double datum = 0.0;          // m
    double freeboard = 5.0;      // m
    std::string crs;
    Nodata nodata = Nodata::refuse;
};

extern const Effect dem_effect;

}  // namespace tidewater::scene
