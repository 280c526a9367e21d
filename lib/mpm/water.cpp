#include "mpm/water.h"

namespace tidewater::mpm {

double hydrostatic_j(double h, double gravity, const WaterModel& water) {
    if (h <= 0.0) return 0.0;
    const double head = water.density * gravity * h / water.bulk_modulus();
    // Newton on f(J) = J^(1−θ) − J − head from the incompressible side; f is convex and falling, so it never
    // overshoots.
    double j = 0.0;
    for (int iteration = 0; iteration < 100; ++iteration) {
        const double power = std::exp((1.0 - water.exponent) * std::log1p(j));  // J^(1−θ)
        const double value = power - (1.0 + j) - head;
        const double slope = (1.0 - water.exponent) * power / (1.0 + j) - 1.0;
        const double change = -value / slope;
        j += change;
        if (std::abs(change) < 1e-16) break;
    }
    return j;
}

}  // namespace tidewater::mpm
