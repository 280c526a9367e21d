// A surface as heights on a lattice: the ground or the ice of an elevation model.
#pragma once

#include <vector>

#include "geometry/box.h"

namespace tidewater::geometry {

// Heights at the lattice points (x0 + i spacing, y0 + j spacing), m, i from 0 to nx − 1, j to ny − 1, at
// index i ny + j. Bilinear between the points, constant beyond them, each along its own axis. ny = 1: the
// same for all y. At least one point. Tests: tests/unit/geometry/height_field_test.cpp.
struct HeightField {
    double spacing = 1.0;  // m
    int nx = 1, ny = 1;
    std::vector<double> heights = {0.0};  // m
    double x0 = 0.0, y0 = 0.0;            // m

    double height(double x, double y) const;
    // (∂z/∂x, ∂z/∂y) of the patch at the place; at a patch's edge that of the patch towards larger x and y.
    Vector<2, double> slope(double x, double y) const;
    // Of all points, so of the whole surface.
    double greatest() const;
    double least() const;
};

// Distance to the surface, m, negative below it: never above the true distance in magnitude, exact where the
// surface is plane, and to first order near any patch: the least over the patches within reach of the
// distance to the patch's mean plane, less what the patch is off that plane (a quarter of its twist z00 + z11
// − z01 − z10). At most `within` (m) in magnitude: what is farther is not looked at, so that a narrow band of
// a large field is quick.
double signed_distance(const HeightField& field, const Point& point, double within = 1e300);

struct Rectangle {
    double x_low, y_low, x_high, y_high;  // m
};

// ∫ of max(z − level, 0) over the rectangle, m³. Exact. The volume below the surface down to a level, or, of
// two, between them: between the heights a and b > a it is volume_above(a) − volume_above(b).
double volume_above(const HeightField& field, const Rectangle& rectangle, double level);

}  // namespace tidewater::geometry
