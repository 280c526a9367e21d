// Bodies as functions of place, put together from simple ones, and their volumes.
#pragma once

#include <functional>

#include "geometry/box.h"
#include "geometry/polygon.h"

namespace tidewater::geometry {

// Signed distance to the surface, m, negative inside. Its magnitude never exceeds the true distance and its
// zero is exact, so that a part of space can be told to be wholly inside or outside; where bodies meet in
// edges it may be less. May be called in parallel.
using Solid = std::function<double(const Point&)>;

Solid box_solid(const Box& box);

// What the outline covers between two planes across y.
Solid prism(Polygon outline, double from_y, double to_y);

// What both cover; what `from` covers without what `taken` does. An empty `taken` takes nothing.
Solid common(Solid a, Solid b);
Solid without(Solid from, Solid taken);

// Volume (m³) within a box whose edges are the extent's; with dimension 2 the area (m²) in the plane y = 0.
// By a tree of cells from `cell` (m) down to cell/2^levels, of which those that the surface crosses count by
// the share below a plane at the body's value and slope in their middle. Measured (solid_test.cpp,
// height_solid_test.cpp) at cells/4: a box along the cells 1e-15, a turned box 1e-4, a ball of 10 cells'
// radius within 1e-4 of its volume, a fjord's ice 3e-4 (4e-5 at cells/8); a disc at cells/32 6e-6. Same
// result on any number of threads.
double volume(const Solid& solid, const Extent& extent, double cell, int levels, int dimension);

}  // namespace tidewater::geometry
