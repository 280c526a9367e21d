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

// Share of the rise from one point to the next at the share t of the way.
double ramp(double t) { return t * t * (3.0 - 2.0 * t); }

// t with ramp(t) = share, from 0 to 1: the cubic's middle root.
double ramp_place(double share) { return 0.5 - std::sin(std::asin(1.0 - 2.0 * share) / 3.0); }

// ∫ of max(a + (b − a) ramp(t), 0) over t from t0 to t1. The ramp rises, so it crosses zero once at most.
double positive_ramp(double a, double b, double t0, double t1) {
    if (a <= 0.0 && b <= 0.0) return 0.0;
    if (a < 0.0 || b < 0.0) {
        const double crossing = std::clamp(ramp_place(-a / (b - a)), t0, t1);
        (a < 0.0 ? t0 : t1) = crossing;
    }
    const auto integral = [](double t) { return t * t * t * (1.0 - 0.5 * t); };
    return a * (t1 - t0) + (b - a) * (integral(t1) - integral(t0));
}

// The ramp from one point to the next as a curve over t from 0 to 1.
struct Ramp {
    Point2 from, rise;

    Point2 at(double t) const { return {from[0] + t * rise[0], from[1] + ramp(t) * rise[1]}; }
};

// The lesser of `least` and the distance from the point to the part of the ramp between t0 and t1. The part
// lies in the box of its ends and within |s″|/8 (t1 − t0)² ≤ ¾ (t1 − t0)² times the rise of its chord; parts
// that are farther by either are left out, and the others are halved, the nearer half first.
double least_distance(const Ramp& ramp, double t0, double t1, const Point2& point, double least) {
    const Point2 from = ramp.at(t0), to = ramp.at(t1);
    if ((point.cwiseMax(from.cwiseMin(to)).cwiseMin(from.cwiseMax(to)) - point).norm() >= least) return least;
    const double off = 0.75 * (t1 - t0) * (t1 - t0) * std::abs(ramp.rise[1]);
    const double nearest = distance_to_segment(from, to, point) - off;
    if (nearest >= least) return least;
    if (off <= 1e-9 * ramp.rise.lpNorm<1>()) return std::max(nearest, 0.0);
    const double middle = 0.5 * (t0 + t1);
    const bool left_first = point[0] < ramp.at(middle)[0];
    least = least_distance(ramp, left_first ? t0 : middle, left_first ? middle : t1, point, least);
    return least_distance(ramp, left_first ? middle : t0, left_first ? t1 : middle, point, least);
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
    const double t = (at - x[next - 1]) / (x[next] - x[next - 1]);
    const double share = smooth ? ramp(t) : t;
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
    const double above = at[1] - profile.height(at[0]);
    double distance = std::min(distance_to_end(corner(0), -1.0, at), distance_to_end(corner(last), 1.0, at));
    if (profile.smooth) distance = std::min(distance, std::abs(above));  // no farther: leaves out most ramps
    for (std::size_t i = 0; i < last; ++i) {
        distance = profile.smooth
                       ? least_distance({corner(i), corner(i + 1) - corner(i)}, 0.0, 1.0, at, distance)
                       : std::min(distance, distance_to_segment(corner(i), corner(i + 1), at));
    }
    return above < 0.0 ? -distance : distance;
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
        const auto next = static_cast<std::size_t>(
            std::upper_bound(profile.x.begin(), profile.x.end(), stops[i - 1]) - profile.x.begin());
        if (profile.smooth && next > 0 && next < profile.x.size()) {
            const double from = profile.x[next - 1], whole = profile.x[next] - from;
            const double t0 = (stops[i - 1] - from) / whole, t1 = (stops[i] - from) / whole;
            const double a = profile.z[next - 1], b = profile.z[next];
            area += whole * (positive_ramp(a, b, t0, t1) - positive_ramp(a - top, b - top, t0, t1));
        } else {
            const double a = profile.height(stops[i - 1]), b = profile.height(stops[i]);
            area += positive_area(width, a, b) - positive_area(width, a - top, b - top);
        }
    }
    return area;
}

// Straight lines and sides differ most at one of the places looked at; a ramp and a side also where they are
// parallel: s′ = 6t (1 − t) = side's slope over the ramp's mean slope.
double rise_into(const Profile& profile, const Box& box) {
    const auto corners = geometry::corners(box);
    const double reach = geometry::reach(box)[0];
    double rise = -std::numeric_limits<double>::infinity();
    const auto look_at = [&](double x) { rise = std::max(rise, profile.height(x) - lower_side(corners, x)); };
    const auto look_within = [&](double x) {
        if (std::abs(x - box.center[0]) < reach) look_at(x);
    };
    for (const Point2& corner : corners) look_at(corner[0]);
    for (const double x : profile.x) look_within(x);
    for (std::size_t i = 1; profile.smooth && i < profile.x.size(); ++i) {
        const double width = profile.x[i] - profile.x[i - 1];
        for (std::size_t side = 0; side < 2; ++side) {
            const Point2 along = corners[side + 1] - corners[side];
            const double share = along[1] * width / (along[0] * (profile.z[i] - profile.z[i - 1]));
            const double apart = std::sqrt(0.25 - share / 6.0);  // no number if they are nowhere parallel
            look_within(profile.x[i - 1] + (0.5 - apart) * width);
            look_within(profile.x[i - 1] + (0.5 + apart) * width);
        }
    }
    return rise;
}

}  // namespace tidewater::geometry
