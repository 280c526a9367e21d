#include "analysis/box.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace tidewater::analysis {

Box bounds(std::span<const float> points) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        box.low[i % 3] = std::min<double>(box.low[i % 3], points[i]);
        box.high[i % 3] = std::max<double>(box.high[i % 3], points[i]);
    }
    return box;
}

double rear_end(const Box& box, double spacing) { return box.low[0] + std::max(0.1 * box.height(), spacing); }

}  // namespace tidewater::analysis
