// The effect "undercut": melt has cut a notch into the ice's front.
#pragma once

namespace tidewater::scene {

struct Effect;

// The keys of [undercut]; undercut.cpp says what each means.
struct Undercut {
    double depth = 0.0;   // m
    double height = 0.0;  // m
    double below = 0.0;   // m
};

extern const Effect undercut_effect;

}  // namespace tidewater::scene
