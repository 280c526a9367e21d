#include "analysis/glacier_front.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace tidewater::analysis {
namespace {

std::int64_t row_of(double y, double spacing) { return static_cast<std::int64_t>(std::floor(y / spacing)); }

}  // namespace

double FrontRows::at(std::int64_t row) const {
    const std::int64_t index = row - first;
    return index < 0 || index >= static_cast<std::int64_t>(x.size()) ? none
                                                                     : x[static_cast<std::size_t>(index)];
}

double FrontRows::median() const {
    std::vector<double> known;
    std::ranges::copy_if(x, std::back_inserter(known), [](double value) { return !std::isnan(value); });
    if (known.empty()) return none;
    std::ranges::sort(known);
    const std::size_t half = known.size() / 2;
    return known.size() % 2 ? known[half] : 0.5 * (known[half - 1] + known[half]);
}

FrontRows find_front(std::span<const float> points, std::span<const std::uint32_t> members,
                     const FrontSettings& settings) {
    assert(settings.spacing > 0.0);
    std::map<std::int64_t, double> greatest;  // of each row
    for (const std::uint32_t p : members) {
        const double x = points[3 * p], z = points[3 * p + 2];
        if (z < settings.low || z > settings.high) continue;
        const auto [at, is_new] = greatest.try_emplace(row_of(points[3 * p + 1], settings.spacing), x);
        at->second = std::max(at->second, x);
    }
    if (greatest.empty()) return {};
    FrontRows rows{greatest.begin()->first, {}};
    rows.x.assign(static_cast<std::size_t>(greatest.rbegin()->first - rows.first + 1), none);
    for (const auto& [row, x] : greatest)
        rows.x[static_cast<std::size_t>(row - rows.first)] = x + 0.5 * settings.spacing;
    return rows;
}

double break_distance(std::span<const float> points, std::span<const std::uint32_t> iceberg,
                      const FrontRows& before, double spacing) {
    std::map<std::pair<std::int64_t, std::int64_t>, double> rear;  // of each line
    for (const std::uint32_t p : iceberg) {
        const double x = points[3 * p] - 0.5 * spacing;
        const std::pair line(row_of(points[3 * p + 1], spacing), row_of(points[3 * p + 2], spacing));
        const auto [at, is_new] = rear.try_emplace(line, x);
        at->second = std::min(at->second, x);
    }
    double sum = 0.0, count = 0.0;
    for (const auto& [line, x] : rear) {
        const double front = before.at(line.first);
        if (std::isnan(front)) continue;
        sum += front - x;
        count += 1.0;
    }
    return count > 0.0 ? sum / count : none;
}

}  // namespace tidewater::analysis
