// The effect "cliff": noise makes the ice's front irregular.
#pragma once

namespace tidewater::scene {

struct Effect;

// The keys of [cliff]; cliff.cpp says what each means.
struct Cliff {
    double amplitude = 0.0;        // m
    double wavelength = 100.0;     // m
    double wavelength_up = 100.0;  // m
};

extern const Effect cliff_effect;

}  // namespace tidewater::scene
