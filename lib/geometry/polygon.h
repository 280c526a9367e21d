// Outlines in the x–z plane.
#pragma once

#include <optional>
#include <vector>

#include "core/types.h"

namespace tidewater::geometry {

using Polygon =
    std::vector<Vector<2, double>>;  // corners (x, z) in m, each next to the one before it; closed

// m², whichever way it runs. Of an outline that does not cross itself. Exact.
double area(const Polygon& polygon);

// The part where side · (coordinate `axis`) ≤ limit (Sutherland & Hodgman 1974). Where the outline enters and
// leaves it several times, the parts hang together along the limit by edges that hold no area.
Polygon clipped(const Polygon& polygon, int axis, double side, double limit);

// m², of what lies below z. Exact.
double area_below(const Polygon& polygon, double z);

// m to the outline, negative inside. Exact.
double signed_distance(const Polygon& polygon, const Vector<2, double>& point);

// The greatest z of the outline at x, m; nothing beyond its ends.
std::optional<double> top_at(const Polygon& polygon, double x);

// The greatest x of the outline at z, m; nothing above and below it.
std::optional<double> front_at(const Polygon& polygon, double z);

// Where two edges that are not neighbours meet; nothing if none do.
std::optional<Vector<2, double>> crossing(const Polygon& polygon);

// By how much the outline has to be raised so that the `share` (from 0 to 1) of its area lies below `level`,
// m: how a body of this share of water's density floats upright. To rounding, by bisection.
double rise_to_float(const Polygon& polygon, double level, double share);

}  // namespace tidewater::geometry
