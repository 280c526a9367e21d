// The ground's height along x, the same for all y.
#pragma once

#include <vector>

#include "geometry/box.h"

namespace tidewater::geometry {

// Points (x, z), m; x rises, and beyond the first and the last the height is theirs. At least one point.
// Between two points the height is
//
//     z0 + (z1 − z0) s(t),  t = (x − x0)/(x1 − x0)
//
// with s = t (straight lines), or, `smooth`, s = 3t² − 2t³: a ramp that is level at both points, so that the
// slope has no jumps and no height lies beyond those of the points. Its steepest slope is 1.5 times the
// line's. Tests: tests/unit/geometry/profile_test.cpp.
struct Profile {
    std::vector<double> x, z;
    bool smooth = false;

    double height(double at) const;
    double highest(double from, double to) const;  // between two places
};

// Distance to the ground's surface, m; negative in the ground. Exact for lines; at ramps never above the true
// distance in magnitude, and below it by at most a billionth of the ramp's width and height. y does not
// count.
double signed_distance(const Profile& profile, const Point& point);

// Area of the ground between x = 0 and x = length that lies above z = 0 and below z = top, m². Exact.
double area_below(const Profile& profile, double length, double top);

// The most by which the ground rises above the lower side of a box, m; at most 0 if it does not reach into
// it. Exact.
double rise_into(const Profile& profile, const Box& box);

}  // namespace tidewater::geometry
