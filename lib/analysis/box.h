// The box that holds the ice at rest, and what of it is the rear.
#pragma once

#include <array>
#include <span>

namespace tidewater::analysis {

struct Box {
    std::array<double, 3> low, high;  // of the particles' centres, m; of none: +∞, −∞

    double height() const { return high[2] - low[2]; }
};

// points holds (x, y, z) of each particle, m.
Box bounds(std::span<const float> points);

// The rear is what lies within a tenth of the height, and at least a spacing, of the least x: up to this x.
double rear_end(const Box& box, double spacing);

}  // namespace tidewater::analysis
