#include "analysis/run_up.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace tidewater::analysis {

Waterline find_waterline(std::span<const double> x, std::span<const double> bed,
                         std::span<const double> elevation, const Shore& shore) {
    assert(x.size() == bed.size() && x.size() == elevation.size() && shore.depth_of_open_water > 0.0);
    const std::size_t count = x.size();
    // Places are counted from the end of the tank inward.
    const auto index = [&](std::size_t n) { return shore.to_the_right ? count - 1 - n : n; };
    std::size_t n = 0;
    while (n < count && shore.still_level - bed[index(n)] < shore.depth_of_open_water) ++n;
    while (n < count && std::isnan(elevation[index(n)])) ++n;
    if (n == count) return {};
    while (n > 0 && !std::isnan(elevation[index(n - 1)])) --n;

    const std::size_t wet = index(n);
    const double surface = shore.still_level + elevation[wet];
    if (n == 0) return {x[wet], elevation[wet], true};
    const std::size_t dry = index(n - 1);
    const double rise = bed[dry] - bed[wet];
    const double share = rise > 0.0 ? std::clamp((surface - bed[wet]) / rise, 0.0, 1.0) : 0.0;
    return {std::lerp(x[wet], x[dry], share), std::lerp(bed[wet], bed[dry], share) - shore.still_level,
            false};
}

}  // namespace tidewater::analysis
