// The effect "cracks": cracks between Voronoi cells part the ice.
#pragma once

namespace tidewater::scene {

struct Effect;

// The keys of [cracks]; cracks.cpp says what each means.
struct Cracks {
    double cell_size = 0.0;  // m
    double width = 0.0;      // m
    double cohesion = 0.0;   // share of the strength of intact ice
};

extern const Effect cracks_effect;

}  // namespace tidewater::scene
