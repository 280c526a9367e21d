// The effect "outlet": water above the still level leaves at the right end of the tank.
#pragma once

namespace tidewater::scene {

struct Effect;

// The keys of [outlet]; outlet.cpp says what each means.
struct Outlet {
    double width = 0.0;  // m
};

extern const Effect outlet_effect;

}  // namespace tidewater::scene
