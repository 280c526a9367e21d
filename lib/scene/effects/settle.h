// The effect "settle": before the run begins, the bodies come to rest under gravity.
#pragma once

namespace tidewater::scene {

struct Effect;

// The keys of [settle]; settle.cpp says what each means.
struct Settle {
    double tolerance = 1e4;   // Pa
    double max_time = 100.0;  // s
};

extern const Effect settle_effect;

}  // namespace tidewater::scene
