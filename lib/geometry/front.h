// What time has made of a glacier's straight front: an irregular cliff, and the notch that melt cuts into it.
#pragma once

#include <cstdint>

#include "geometry/solid.h"

namespace tidewater::geometry {

// The cliff: places are shifted along x by
//
//     s(x, y, z) = a n(y/λ_y, z/λ_z) clamp((x − rear)/(front − rear), 0, 1),   n: simplex noise in [−1, 1]
//
// so that the front lies up to a before or behind where it was and the rear stays. In 2D n is that of y = 0.
// a should be well below the length and the wavelengths; 0: none.
struct Cliff {
    double amplitude = 0.0;                            // a, m
    double wavelength = 100.0, wavelength_up = 100.0;  // λ_y, λ_z, m
    std::uint64_t seed = 1;
};

// The notch: what lies within half an ellipse that opens at the front, of this depth along x and height along
// z, over the whole width; on an irregular cliff it follows it. Area of the section π depth height/4. depth
// 0: none.
struct Notch {
    double depth = 0.0, height = 0.0;  // m
    double top = 0.0;                  // z, m
};

// `ice` between the places `rear` and `front` along x, the latter at the notch's height, with both.
Solid with_front(Solid ice, double rear, double front, const Cliff& cliff, const Notch& notch);

}  // namespace tidewater::geometry
