// The effect "crevasses": wedges are cut into the ice's surface.
#pragma once

#include <vector>

namespace tidewater::scene {

struct Effect;

// The keys of [crevasses]; crevasses.cpp says what each means.
struct Crevasses {
    double spacing = 0.0;                    // m
    std::vector<double> depth{20.0, 50.0};   // m, minimum and maximum
    std::vector<double> opening{5.0, 10.0};  // m, minimum and maximum
    double from = 0.0;                       // m
    double to = 0.0;                         // m; 0 is the front
    double angle = 0.0;                      // degrees
    double length = 0.0;                     // m; 0 is the whole width
    double wander = 0.0;                     // m
    double wavelength = 200.0;               // m
};

extern const Effect crevasses_effect;

}  // namespace tidewater::scene
