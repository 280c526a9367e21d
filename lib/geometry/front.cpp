#include "geometry/front.h"

#include <algorithm>
#include <cmath>

#include "geometry/noise.h"

namespace tidewater::geometry {
namespace {

// The ellipse's equation as a length: its slope is at most 1, so it never exceeds the distance.
Solid ellipse(double x, double z, double half_x, double half_z) {
    return [=](const Point& point) {
        const double out = std::hypot((point[0] - x) / half_x, (point[2] - z) / half_z);
        return (out - 1.0) * std::min(half_x, half_z);
    };
}

}  // namespace

Solid with_front(Solid ice, double rear, double front, const Cliff& cliff, const Notch& notch) {
    if (notch.depth > 0.0) {
        const double half = 0.5 * notch.height;
        ice = without(std::move(ice), ellipse(front, notch.top - half, notch.depth, half));
    }
    if (cliff.amplitude == 0.0) return ice;
    // |∂s/∂x|² + … ≤ a² (1/L² + g²/λ²): the steepest that shifted places can lie
    const double shortest = std::min(cliff.wavelength, cliff.wavelength_up);
    const double steepest = cliff.amplitude * std::hypot(1.0 / (front - rear), plane_noise_slope / shortest);
    return [=, ice = std::move(ice)](const Point& point) {
        const double along = std::clamp((point[0] - rear) / (front - rear), 0.0, 1.0);
        const double shift =
            cliff.amplitude * along *
            simplex_noise(cliff.seed, point[1] / cliff.wavelength, point[2] / cliff.wavelength_up);
        return ice(point - Point(shift, 0.0, 0.0)) / (1.0 + steepest);
    };
}

}  // namespace tidewater::geometry
