// The effect "shelf": a block of ground without friction at the left wall, which may retreat under the ice.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::scene {

struct Effect;

// The keys of [shelf]; shelf.cpp says what each means.
struct Shelf {
    double length = 0.0;   // m
    double height = 0.0;   // m
    double retreat = 0.0;  // m/s
    mpm::WallRule wall = mpm::WallRule::separate;
};

extern const Effect shelf_effect;

}  // namespace tidewater::scene
