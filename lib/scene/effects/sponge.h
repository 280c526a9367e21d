// The effect "sponge": a layer at the right wall damps waves.
#pragma once

namespace tidewater::scene {

struct Effect;

// The keys of [sponge]; sponge.cpp says what each means.
struct Sponge {
    double width = 0.0;      // m
    double strength = 10.0;  // damping at the wall over √(g water.depth)/width
};

extern const Effect sponge_effect;

}  // namespace tidewater::scene
