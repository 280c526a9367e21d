#include "analysis/calving.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/box.h"
#include "analysis/detachment.h"
#include "analysis/failure_surface.h"

namespace tidewater::analysis {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();

// With `never` for what never failed and for the rear.
std::vector<float> failure_times(const IceAtRest& ice, double end_of_rear) {
    std::vector<float> times(ice.failure_time.begin(), ice.failure_time.end());
    for (std::size_t p = 0; p < times.size(); ++p) {
        if (std::isnan(times[p]) || ice.points[3 * p] <= end_of_rear) times[p] = never;
    }
    return times;
}

double smallest_volume(const Box& box, const CalvingSettings& settings) {
    const double height = box.height() + settings.spacing;
    const double width = settings.dimension == 3 ? box.high[1] - box.low[1] + settings.spacing : 1.0;
    return settings.smallest_share * height * height * width;
}

// On which side of the crack each particle was just after the detachment.
std::vector<Side> divide(const IceAtRest& ice, std::span<const float> times, const Detachment& detachment,
                         double end_of_rear, double reach) {
    std::vector<std::uint8_t> intact;
    for (const float time : times) intact.push_back(time > detachment.time);
    const Fragments fragments = label_fragments(ice.points, intact, reach);
    std::vector<Side> sides(fragments.size.size(), Side::neither);
    for (std::size_t p = 0; p < times.size(); ++p) {
        if (ice.points[3 * p] <= end_of_rear) sides[fragments.label[p]] = Side::rear;
    }
    sides[fragments.label[detachment.particle]] = Side::iceberg;
    std::vector<Side> of_particle;
    for (const std::uint32_t label : fragments.label)
        of_particle.push_back(label == Fragments::none ? Side::neither : sides[label]);
    return of_particle;
}

}  // namespace

double smallest_iceberg(const IceAtRest& ice, const CalvingSettings& settings) {
    return smallest_volume(bounds(ice.points), settings);
}

std::optional<Calving> first_detachment(const IceAtRest& ice, const CalvingSettings& settings) {
    assert(ice.points.size() == 3 * ice.volume.size() && ice.volume.size() == ice.failure_time.size());
    assert(settings.spacing > 0.0);
    if (ice.volume.empty()) return {};
    const Box box = bounds(ice.points);
    const double spacing = settings.spacing, end_of_rear = rear_end(box, spacing);
    const std::vector<float> times = failure_times(ice, end_of_rear);
    const auto detachment = find_detachment(ice, times,
                                            {.end_of_rear = end_of_rear,
                                             .reach = settings.reach * spacing,
                                             .smallest_volume = smallest_volume(box, settings)});
    if (!detachment) return {};

    const auto sides = divide(ice, times, *detachment, end_of_rear, settings.reach * spacing);
    return measure_calving(ice, sides, detachment->time, settings);
}

}  // namespace tidewater::analysis
