#include "mpm/materials/water.h"

#include <algorithm>

namespace tidewater::mpm {

double weighed_depth(double h, double gravity, const WaterModel& water) {
    const double per_depth = water.density * gravity / water.bulk_modulus();  // ρw g / κw, 1/m
    if (h <= 0.0 || per_depth == 0.0) return h;
    const double power = 1.0 - 1.0 / water.exponent;
    return std::expm1(std::log1p(power * per_depth * h) / power) / per_depth;
}

double depth_of_weight(double mass, double gravity, const WaterModel& water) {
    const double per_depth = water.density * gravity / water.bulk_modulus();
    if (mass <= 0.0 || per_depth == 0.0) return mass;
    const double power = 1.0 - 1.0 / water.exponent;
    return std::expm1(power * std::log1p(per_depth * mass)) / (power * per_depth);
}

double j_under_weight(double mass, double gravity, const WaterModel& water) {
    const double per_depth = water.density * gravity / water.bulk_modulus();
    return std::expm1(-std::log1p(per_depth * std::max(mass, 0.0)) / water.exponent);
}

double hydrostatic_j(double h, double gravity, const WaterModel& water) {
    if (h <= 0.0) return 0.0;
    const double head = water.density * gravity * h / water.bulk_modulus();
    // Newton's method for f(J) = J^(1−θ) − J − head. f is convex and decreasing, and f > 0 at the start,
    // where J^(1−θ) = 1 + head. So J grows towards the root without passing it.
    double j = std::expm1(std::log1p(head) / (1.0 - water.exponent));
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
