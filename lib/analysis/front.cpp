#include "analysis/front.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "analysis/series.h"
#include "core/types.h"

namespace tidewater::analysis {

double water_front(std::span<const float> points, std::span<const std::uint8_t> material, double gap) {
    assert(points.size() == 3 * material.size());
    std::vector<double> along;
    for (std::size_t p = 0; p < material.size(); ++p) {
        if (material[p] == static_cast<std::uint8_t>(Material::water))
            along.push_back(static_cast<double>(points[3 * p]));
    }
    if (along.empty()) return none;
    std::ranges::sort(along);
    const auto end = std::ranges::adjacent_find(along, [gap](double a, double b) { return b - a > gap; });
    return end == along.end() ? along.back() : *end;
}

}  // namespace tidewater::analysis
