// Boxes: what tanks, water bodies and blocks are made of. Coordinates (x, y, z) in m; a 2D scene is the plane
// y = 0, and its boxes reach from −half_size.y to half_size.y around it.
#pragma once

#include "core/types.h"

namespace tidewater::geometry {

using Point = Vector<3, double>;

struct Box {
    Point center = Point::Zero();
    Point half_size = Point::Zero();
    double angle = 0.0;  // rad, turned in the x–z plane about its centre, from x towards z
};

// Exact distance to the box's surface, m; negative inside.
double signed_distance(const Box& box, const Point& point);

// Area in the x–z plane that a turned box shares with an upright one (angle ignored), m². Exact: the turned
// rectangle is clipped at the upright one's four sides (Sutherland & Hodgman 1974).
double shared_area(const Box& turned, const Box& upright);

}  // namespace tidewater::geometry
