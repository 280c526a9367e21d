#include "analysis/calving_rate.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace tidewater::analysis {
namespace {

// What came off up to `at`, by the totals at the times.
double total_at(std::span<const double> time, std::span<const double> total, double at) {
    const auto after = std::ranges::upper_bound(time, at);
    if (after == time.begin()) return total.front();
    if (after == time.end()) return total.back();
    const auto i = static_cast<std::size_t>(after - time.begin());
    return total[i - 1] + (total[i] - total[i - 1]) * (at - time[i - 1]) / (time[i] - time[i - 1]);
}

}  // namespace

std::vector<double> calving_rate(std::span<const double> time, std::span<const double> calved,
                                 double window) {
    assert(time.size() == calved.size() && window > 0.0);
    std::vector<double> total(time.size(), 0.0), rate(time.size(), 0.0);
    for (std::size_t i = 1; i < time.size(); ++i) total[i] = total[i - 1] + calved[i];
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double from = std::max(time.front(), time[i] - 0.5 * window);
        const double to = std::min(time.back(), time[i] + 0.5 * window);
        if (to > from) rate[i] = (total_at(time, total, to) - total_at(time, total, from)) / (to - from);
    }
    return rate;
}

}  // namespace tidewater::analysis
