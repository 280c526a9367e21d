// The effect "push": a plane that starts at the left wall pushes what stands before it.
#pragma once

namespace tidewater::scene {

struct Effect;

// The keys of [push]; push.cpp says what each means.
struct Push {
    double speed = 0.0;  // m/s
    double ramp = 0.0;   // s
};

extern const Effect push_effect;

}  // namespace tidewater::scene
