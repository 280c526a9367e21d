#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tidewater::geometry {
namespace {

using Corner = Vector<2, double>;

double cross(const Corner& a, const Corner& b) { return a[0] * b[1] - a[1] * b[0]; }

// The greatest coordinate `of` of the outline where its other coordinate is `at`.
std::optional<double> greatest(const Polygon& polygon, int of, double at) {
    std::optional<double> found;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Corner &a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
        const double from = a[1 - of], to = b[1 - of];
        if (at < std::min(from, to) || at > std::max(from, to)) continue;
        const double there =
            from == to ? std::max(a[of], b[of]) : a[of] + (at - from) / (to - from) * (b[of] - a[of]);
        if (!found || there > *found) found = there;
    }
    return found;
}

}  // namespace

double area(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t n = 0; n < polygon.size(); ++n)
        twice += cross(polygon[n], polygon[(n + 1) % polygon.size()]);
    return 0.5 * std::abs(twice);
}

Polygon clipped(const Polygon& polygon, int axis, double side, double limit) {
    Polygon kept;
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

double area_below(const Polygon& polygon, double z) { return area(clipped(polygon, 1, 1.0, z)); }

double signed_distance(const Polygon& polygon, const Vector<2, double>& point) {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Corner &a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
        const Corner along = b - a;
        const double length2 = along.squaredNorm();
        const double share = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, (a + share * along - point).squaredNorm());
        if ((a[1] > point[1]) !=
            (b[1] > point[1]))  // the ray from the point along +x crosses the edge's line
            inside ^= point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * along[0];
    }
    return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

std::optional<double> top_at(const Polygon& polygon, double x) { return greatest(polygon, 1, x); }

std::optional<double> front_at(const Polygon& polygon, double z) { return greatest(polygon, 0, z); }

std::optional<Vector<2, double>> crossing(const Polygon& polygon) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 2; j < count; ++j) {
            if (i == 0 && j == count - 1) continue;
            const Corner &a = polygon[i], &b = polygon[j];
            const Corner u = polygon[i + 1] - a, v = polygon[(j + 1) % count] - b;
            const double turn = cross(u, v);
            if (turn == 0.0) continue;
            const double s = cross(b - a, v) / turn, t = cross(b - a, u) / turn;
            if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) return a + s * u;
        }
    }
    return {};
}

double rise_to_float(const Polygon& polygon, double level, double share) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Corner& corner : polygon) {
        lowest = std::min(lowest, corner[1]);
        highest = std::max(highest, corner[1]);
    }
    double low = level - highest, high = level - lowest;  // wholly below, wholly above
    for (int n = 0; n < 100; ++n) {
        const double rise = 0.5 * (low + high);
        (area_below(polygon, level - rise) > share * area(polygon) ? low : high) = rise;
    }
    return 0.5 * (low + high);
}

}  // namespace tidewater::geometry
