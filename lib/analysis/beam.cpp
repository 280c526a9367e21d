#include "analysis/beam.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace tidewater::analysis {

Overhang submerged(const Overhang& overhang) {
    Overhang result = overhang;
    result.depth = std::min(overhang.depth, overhang.height);
    return result;
}

double load_share(const Overhang& overhang) {
    assert(overhang.height > 0.0 && overhang.depth >= 0.0);
    return 1.0 - overhang.water_density * overhang.depth / (overhang.ice_density * overhang.height);
}

// σ = 3 ρi g L² |n| / H
double surface_stress(const Overhang& overhang, double length) {
    return 3.0 * overhang.ice_density * overhang.gravity * length * length * std::abs(load_share(overhang)) /
           overhang.height;
}

// L/H = √(σt / (3 ρi g H |n|)), where the divisor is the stress of a beam as long as it is high
double beam_length_ratio(const Overhang& overhang, double strength) {
    return std::sqrt(strength / surface_stress(overhang, overhang.height));
}

double paper_length_ratio(const Overhang& overhang, double strength) {
    return std::numbers::sqrt2 * beam_length_ratio(overhang, strength);
}

}  // namespace tidewater::analysis
