// The ground's height along x, the same for all y.
#pragma once

#include <vector>

#include "geometry/box.h"

namespace tidewater::geometry {

// Straight lines between the points (x, z), m; x rises, and beyond the first and the last the height is
// theirs. At least one point.
struct Profile {
    std::vector<double> x, z;

    double height(double at) const;
    double highest(double from, double to) const;  // between two places
};

// Distance to the ground's surface, m; negative in the ground. Exact; y does not count.
double signed_distance(const Profile& profile, const Point& point);

// Area of the ground between x = 0 and x = length that lies above z = 0 and below z = top, m². Exact.
double area_below(const Profile& profile, double length, double top);

// The most by which the ground rises above the lower side of a box, m; at most 0 if it does not reach into
// it. Exact.
double rise_into(const Profile& profile, const Box& box);

}  // namespace tidewater::geometry
