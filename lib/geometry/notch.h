// The section of a crevasse: a notch in a level surface, the same on both sides, with straight flanks and a
// round tip. q is the distance from its middle plane and b that below the surface, m; above the surface the
// notch goes on upward as wide as it is there. Test: tests/unit/geometry/crevasses_test.cpp
#pragma once

#include <array>

namespace tidewater::geometry {

struct Notch {
    static constexpr double tip_share = 0.125;  // radius of the tip, of the opening

    double half = 0.0;    // of the opening
    double radius = 0.0;  // of the circle around (0, center) that is the tip
    double center = 0.0;
    double flank = 0.0;  // length of a flank, from (half, 0) to where it touches the circle
    std::array<double, 2> normal{1.0, 0.0};  // of the flank, outward: (q, b)

    Notch(double depth, double opening);  // m; depth above opening/8, or both 0

    double signed_distance(double q, double b) const;  // m, negative inside; exact
    double area() const;                               // m² below the surface, both sides; exact
};

}  // namespace tidewater::geometry
