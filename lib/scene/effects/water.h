// The effect "water": still water up to one level, unless the effect "wave" shapes its surface.
#pragma once

#include "mpm/materials/water.h"

namespace tidewater::scene {

struct Effect;

// The keys of [water]; water.cpp says what each means.
struct Water {
    double depth = 0.0;         // m
    double submergence = -1.0;  // D/H. The depth follows from it unless it is negative.
    double length = 0.0;        // m; 0 is the whole tank
    mpm::WaterModel model;      // water.density, .sound_speed, .exponent, .scheme and .tension
};

extern const Effect water_effect;

}  // namespace tidewater::scene
