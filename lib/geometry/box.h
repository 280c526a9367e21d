// Boxes: what tanks, water bodies and blocks are made of. Coordinates (x, y, z) in m; a 2D scene is the plane
// y = 0, and its boxes reach from −half_size.y to half_size.y around it.
#pragma once

#include <array>

#include "core/types.h"

namespace tidewater::geometry {

using Point = Vector<3, double>;

struct Extent {
    Point low, high;  // m; what it holds lies between
};

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

// The corners in the x–z plane, (x, z) in m, each next to the one before it.
std::array<Vector<2, double>, 4> corners(const Box& box);

// Half the edges of the upright box around it, m.
Point reach(const Box& box);

// By how much two boxes are apart along the axis that separates them best, m: at most their distance; 0 if
// they touch. Negative: they share room, and −separation is the shortest way by which one has to move to be
// clear. By the separating axis test (Gottschalk et al. 1996).
double separation(const Box& a, const Box& b);

// Area in the x–z plane that lies below the height z, m². Exact.
double area_below(const Box& box, double z);

// Height of the centre, m, at which the share (from 0 to 1) of the box's area lies below `level`: how a body
// of this share of water's density floats if it keeps its angle; of a box turned about y also in 3D. To
// rounding, by bisection.
double floating_height(const Box& box, double level, double share);

}  // namespace tidewater::geometry
