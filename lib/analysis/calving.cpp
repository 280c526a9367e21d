#include "analysis/calving.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "analysis/box.h"
#include "analysis/detachment.h"

namespace tidewater::analysis {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();
constexpr double infinity = std::numeric_limits<double>::infinity();

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

enum class Side : std::uint8_t { neither, iceberg, rear };

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

struct Row {
    double z = 0.0;
    double front = -infinity;         // greatest x
    double rear = -infinity;          // greatest x of the rear's part that is behind the iceberg
    double iceberg = infinity;        // least x of the iceberg
    double first_failure = infinity;  // between both, s

    bool cracked() const { return std::isfinite(rear) && std::isfinite(iceberg); }
    double crack() const { return 0.5 * (rear + iceberg); }
};

std::vector<Row> make_rows(const IceAtRest& ice, std::span<const float> times, std::span<const Side> sides,
                           const Box& box, double spacing, float detachment) {
    const auto bin = [&](std::size_t axis, double x) {
        return static_cast<std::size_t>((x - box.low[axis]) / spacing + 0.5);
    };
    const std::size_t heights = bin(2, box.high[2]) + 1;
    std::vector<Row> rows(heights * (bin(1, box.high[1]) + 1));
    for (std::size_t r = 0; r < rows.size(); ++r)
        rows[r].z = box.low[2] + spacing * static_cast<double>(r % heights);
    const auto for_each = [&](const auto& visit) {
        for (std::size_t p = 0; p < times.size(); ++p) {
            const float* at = ice.points.data() + 3 * p;
            visit(rows[bin(1, at[1]) * heights + bin(2, at[2])], p, static_cast<double>(at[0]));
        }
    };
    for_each([&](Row& row, std::size_t p, double x) {
        row.front = std::max(row.front, x);
        if (sides[p] == Side::iceberg) row.iceberg = std::min(row.iceberg, x);
    });
    for_each([&](Row& row, std::size_t p, double x) {
        if (sides[p] == Side::rear && x < row.iceberg) row.rear = std::max(row.rear, x);
    });
    for_each([&](Row& row, std::size_t p, double x) {
        if (times[p] <= detachment && row.cracked() && row.rear < x && x < row.iceberg)
            row.first_failure = std::min<double>(row.first_failure, times[p]);
    });
    return rows;
}

// Of the ice in front of the crack.
struct Height {
    double low, thickness;
    double share(double z) const { return (z - low) / thickness; }
};

Height front_height(const IceAtRest& ice, double crack, double spacing) {
    double low = infinity, high = -infinity;
    for (std::size_t i = 0; i < ice.points.size(); i += 3) {
        if (ice.points[i] < crack) continue;
        low = std::min<double>(low, ice.points[i + 2]);
        high = std::max<double>(high, ice.points[i + 2]);
    }
    return {low - 0.5 * spacing, high - low + spacing};
}

// Mean of value(row) over the cracked rows between two shares of the height; NaN if there is none.
template <class Value>
double mean(std::span<const Row> rows, const Height& height, double from, double to, const Value& value) {
    double sum = 0.0, count = 0.0;
    for (const Row& row : rows) {
        if (!row.cracked() || height.share(row.z) < from || height.share(row.z) > to) continue;
        sum += value(row);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : none;
}

void find_start(std::vector<Row> rows, const Height& height, Calving& calving) {
    std::erase_if(rows, [](const Row& row) { return !std::isfinite(row.first_failure); });
    if (rows.empty()) return;
    std::ranges::sort(rows, {}, &Row::first_failure);
    std::vector<double> shares;
    for (const Row& row : rows) {
        if (row.first_failure <= rows[rows.size() / 2].first_failure) shares.push_back(height.share(row.z));
    }
    const auto median = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::ranges::nth_element(shares, median);
    calving.start_height = *median;
    const auto there = [&](const Row& row) { return crack_start(height.share(row.z)) == calving.start(); };
    calving.start_time = std::ranges::find_if(rows, there)->first_failure;
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
    Calving calving{.time = detachment->time, .volume = 0.0};
    for (std::size_t p = 0; p < sides.size(); ++p) {
        if (sides[p] == Side::iceberg) calving.volume += ice.volume[p];
    }
    const auto rows = make_rows(ice, times, sides, box, spacing, detachment->time);
    const Height any{box.low[2], 1.0};
    const double crack = mean(rows, any, -infinity, infinity, [](const Row& row) { return row.crack(); });
    if (std::isnan(crack)) return calving;

    const Height height = front_height(ice, crack, spacing);
    const auto length = [&](double from, double to) {
        return mean(rows, height, from, to,
                    [&](const Row& row) { return row.front + 0.5 * spacing - row.crack(); });
    };
    const double band = std::max(0.05, spacing / height.thickness);
    calving.length = length(-infinity, infinity);
    calving.length_top = length(1.0 - band, infinity);
    calving.length_middle = length(0.5 - band, 0.5 + band);
    calving.length_bottom = length(-infinity, band);
    calving.height = height.thickness;
    find_start(rows, height, calving);
    return calving;
}

}  // namespace tidewater::analysis
