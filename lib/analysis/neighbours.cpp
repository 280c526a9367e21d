#include "analysis/neighbours.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace tidewater::analysis {

CellPoints sort_into_cells(std::span<const float> points, std::span<const std::uint32_t> chosen,
                           double reach) {
    assert(reach > 0.0);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    for (const std::uint32_t p : chosen) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = points[3 * p + axis];
            low[axis] = std::min(low[axis], x);
            high[axis] = std::max(high[axis], x);
        }
    }
    const auto cell = [&](std::size_t axis, double x) {
        return static_cast<std::uint64_t>((x - low[axis]) / reach) + 1;
    };
    CellPoints result{};
    if (chosen.empty()) return result;
    const std::uint64_t row = cell(0, high[0]) + 2, layer = row * (cell(1, high[1]) + 2);
    result.next_rows = {row, layer - row, layer, layer + row};
    result.points.reserve(chosen.size());
    for (const std::uint32_t p : chosen) {
        const std::array at{points[3 * p], points[3 * p + 1], points[3 * p + 2]};
        result.points.push_back({cell(0, at[0]) + row * cell(1, at[1]) + layer * cell(2, at[2]), p, at});
    }
    std::ranges::sort(result.points, [](const CellPoint& a, const CellPoint& b) {
        return a.cell != b.cell ? a.cell < b.cell : a.index < b.index;
    });
    return result;
}

}  // namespace tidewater::analysis
