#include "analysis/dispersion.h"

#include <cassert>
#include <cmath>

namespace tidewater::analysis {

double dispersion_wavenumber(double frequency, double depth, double gravity) {
    assert(frequency > 0.0 && depth > 0.0 && gravity > 0.0);
    const double deep = frequency * frequency * depth / gravity;  // kD of deep water
    // Newton for u = kD in u tanh u = deep, from above the solution.
    double u = deep + std::sqrt(deep);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const double t = std::tanh(u);
        const double change = (u * t - deep) / (t + u * (1.0 - t * t));
        u -= change;
        if (std::abs(change) < 1e-14 * u) break;
    }
    return u / depth;
}

double group_celerity(double frequency, double depth, double gravity) {
    assert(frequency >= 0.0 && depth > 0.0 && gravity > 0.0);
    if (frequency == 0.0) return std::sqrt(gravity * depth);
    const double k = dispersion_wavenumber(frequency, depth, gravity), twice = 2.0 * k * depth;
    return 0.5 * frequency / k * (1.0 + twice / std::sinh(twice));
}

}  // namespace tidewater::analysis
