// The effect "piston": the left wall moves as a wave maker.
#pragma once

#include "mpm/boundaries/piston.h"

namespace tidewater::scene {

struct Effect;

// The keys of [piston]; piston.cpp says what each means.
struct Piston {
    mpm::PistonMotion motion = mpm::PistonMotion::solitary;
    double height = 0.0;     // m, of a solitary wave
    double amplitude = 0.0;  // m, of a sine
    double period = 0.0;     // s, of a sine
    double ramp = 0.0;       // s, of a sine
};

extern const Effect piston_effect;

}  // namespace tidewater::scene
