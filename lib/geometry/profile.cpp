#include "geometry/profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace tidewater::geometry {
namespace {

using Point2 = Vector<2, double>;

double distance_to_segment(const Point2& from, const Point2& to, const Point2& point) {
    const Point2 along = to - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (from + share * along - point).norm();
}

// Beyond the ends the ground is level.
double distance_to_end(const Point2& end, double outward, const Point2& point) {
    return outward * (point[0] - end[0]) >= 0.0 ? std::abs(point[1] - end[1]) : (point - end).norm();
}

// ∫ of max(z, 0) over a width on which z goes from a to b in a straight line.
double positive_area(double width, double a, double b) {
    if (a >= 0.0 && b >= 0.0) return 0.5 * width * (a + b);
    if (a <= 0.0 && b <= 0.0) return 0.0;
    const double high = std::max(a, b);
    return 0.5 * width * high * high / (high - std::min(a, b));
}

// Height of the box's lower side at x, within the box's reach.
double lower_side(const std::array<Point2, 4>& corners, double x) {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const Point2 &a = corners[n], &b = corners[(n + 1) % corners.size()];
        if (x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
        const double share = a[0] == b[0] ? 0.0 : (x - a[0]) / (b[0] - a[0]);
        lowest = std::min({lowest, a[1] + share * (b[1] - a[1]), a[0] == b[0] ? b[1] : lowest});
    }
    return lowest;
}

}  // namespace

double Profile::height(double at) const {
    assert(!x.empty() && x.size() == z.size());
    const auto next = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
    if (next == 0) return z.front();
    if (next == x.size()) return z.back();
    const double share = (at - x[next - 1]) / (x[next] - x[next - 1]);
    return z[next - 1] + share * (z[next] - z[next - 1]);
}

double Profile::highest(double from, double to) const {
    double most = std::max(height(from), height(to));
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i] > from && x[i] < to) most = std::max(most, z[i]);
    }
    return most;
}

double signed_distance(const Profile& profile, const Point& point) {
    const Point2 at(point[0], point[2]);
    const auto corner = [&](std::size_t i) { return Point2(profile.x[i], profile.z[i]); };
    const std::size_t last = profile.x.size() - 1;
    double distance = std::min(distance_to_end(corner(0), -1.0, at), distance_to_end(corner(last), 1.0, at));
    for (std::size_t i = 0; i < last; ++i) {
        distance = std::min(distance, distance_to_segment(corner(i), corner(i + 1), at));
    }
    return at[1] < profile.height(at[0]) ? -distance : distance;
}

double area_below(const Profile& profile, double length, double top) {
    std::vector<double> stops{0.0};
    for (const double x : profile.x) {
        if (x > 0.0 && x < length) stops.push_back(x);
    }
    stops.push_back(length);
    double area = 0.0;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const double width = stops[i] - stops[i - 1];
        const double a = profile.height(stops[i - 1]), b = profile.height(stops[i]);
        area += positive_area(width, a, b) - positive_area(width, a - top, b - top);
    }
    return area;
}

// Both are straight between the places below, so the difference is greatest at one of them.
double rise_into(const Profile& profile, const Box& box) {
    const auto corners = geometry::corners(box);
    double rise = -std::numeric_limits<double>::infinity();
    const auto look_at = [&](double x) { rise = std::max(rise, profile.height(x) - lower_side(corners, x)); };
    for (const Point2& corner : corners) look_at(corner[0]);
    const double reach = geometry::reach(box)[0];
    for (const double x : profile.x) {
        if (std::abs(x - box.center[0]) < reach) look_at(x);
    }
    return rise;
}

}  // namespace tidewater::geometry
