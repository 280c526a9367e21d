// What lies below a surface given by heights, as a body.
#pragma once

#include "geometry/height_field.h"
#include "geometry/solid.h"

namespace tidewater::geometry {

// The distance along z times the cosine of the steepest slope nearby, which is never more than the true one
// and takes no search; within 3.5 lattice spacings of the surface height_field.h's distance where that is
// more. 9.5 spacings at most. Of a field that begins at x = y = 0. Test:
// tests/unit/geometry/height_solid_test.cpp
Solid below(const HeightField& heights);

}  // namespace tidewater::geometry
