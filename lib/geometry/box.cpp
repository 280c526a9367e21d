#include "geometry/box.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tidewater::geometry {
namespace {

using Corner = Vector<2, double>;  // (x, z)

// Keeps the part of the polygon where side · axis coordinate ≤ limit.
std::vector<Corner> clip(const std::vector<Corner>& polygon, int axis, double side, double limit) {
    std::vector<Corner> kept;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Corner& from = polygon[n];
        const Corner& to = polygon[(n + 1) % polygon.size()];
        const double from_beyond = side * from[axis] - limit;
        const double to_beyond = side * to[axis] - limit;
        if (from_beyond <= 0.0) kept.push_back(from);
        if ((from_beyond < 0.0) != (to_beyond < 0.0) && from_beyond != to_beyond) {
            kept.push_back(from + (to - from) * (from_beyond / (from_beyond - to_beyond)));
        }
    }
    return kept;
}

double polygon_area(const std::vector<Corner>& polygon) {
    double twice = 0.0;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Corner& a = polygon[n];
        const Corner& b = polygon[(n + 1) % polygon.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * std::abs(twice);
}

}  // namespace

double signed_distance(const Box& box, const Point& point) {
    const Point from = point - box.center;
    const double c = std::cos(box.angle), s = std::sin(box.angle);
    const Point own(c * from[0] + s * from[2], from[1], -s * from[0] + c * from[2]);
    const Point beyond = own.cwiseAbs() - box.half_size;
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

double shared_area(const Box& turned, const Box& upright) {
    const double c = std::cos(turned.angle), s = std::sin(turned.angle);
    std::vector<Corner> polygon;
    for (const auto& [x, z] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        const double along = x * turned.half_size[0], across = z * turned.half_size[2];
        polygon.emplace_back(turned.center[0] + c * along - s * across,
                             turned.center[2] + s * along + c * across);
    }
    for (const int axis : {0, 1}) {
        const int axis3 = 2 * axis;
        polygon = clip(polygon, axis, 1.0, upright.center[axis3] + upright.half_size[axis3]);
        polygon = clip(polygon, axis, -1.0, upright.half_size[axis3] - upright.center[axis3]);
    }
    return polygon.empty() ? 0.0 : polygon_area(polygon);
}

}  // namespace tidewater::geometry
