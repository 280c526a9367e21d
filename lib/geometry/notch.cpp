#include "geometry/notch.h"

#include <algorithm>
#include <cmath>

namespace tidewater::geometry {

// The tangent from (half, 0) to the circle: its normal n has n · (half, −center) = radius.
Notch::Notch(double depth, double opening)
    : half(0.5 * opening), radius(tip_share * opening), center(depth - radius) {
    const double squared = half * half + center * center;
    if (squared <= 0.0) return;
    flank = std::sqrt(std::max(squared - radius * radius, 0.0));
    normal = {(radius * half + flank * center) / squared, (flank * half - radius * center) / squared};
}

double Notch::signed_distance(double q, double b) const {
    const double down = b - center;
    const double along = normal[0] * down - normal[1] * q;  // the flank's way, downwards
    if (along > 0.0) return std::hypot(q, down) - radius;
    const double from_wall = q - half, from_flank = normal[0] * q + normal[1] * down - radius;
    if (from_wall <= 0.0 && from_flank <= 0.0) return std::max(from_wall, from_flank);
    if (along >= -flank) return from_flank;
    return b <= 0.0 ? from_wall : std::hypot(from_wall, b);
}

// On each side the triangle of the surface's middle, the flank's upper end and the circle's centre, that of
// the flank and the centre, and a sector of the circle.
double Notch::area() const {
    const double sector = std::atan2(normal[0], normal[1]);
    return half * center + radius * flank + radius * radius * sector;
}

}  // namespace tidewater::geometry
