// The effect "shelf": a block of ground at the left wall, which may retreat under the ice.
#pragma once

#include "scene/ground.h"

namespace tidewater::scene {

struct Effect;

// The keys of [shelf]; shelf.cpp says what each means.
struct Shelf {
    double length = 0.0;   // m
    double height = 0.0;   // m
    double retreat = 0.0;  // m/s
    bool holds_down = false;
    Ground ground;
};

extern const Effect shelf_effect;

}  // namespace tidewater::scene
