// The eigenvector of the least spread is the normal of the plane of least squares (Pearson 1901).
#include "analysis/failure_surface.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "analysis/box.h"

namespace tidewater::analysis {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Row {
    double y = 0.0, z = 0.0;
    double front = -infinity;         // greatest x
    double rear = -infinity;          // greatest x of the rear's part that is behind the iceberg
    double iceberg = infinity;        // least x of the iceberg
    double first_failure = infinity;  // between both, s

    bool cracked() const { return std::isfinite(rear) && std::isfinite(iceberg); }
    double crack() const { return 0.5 * (rear + iceberg); }
};

std::vector<Row> make_rows(const IceAtRest& ice, std::span<const Side> sides, const Box& box, double spacing,
                           double time) {
    const auto bin = [&](std::size_t axis, double x) {
        return static_cast<std::size_t>((x - box.low[axis]) / spacing + 0.5);
    };
    const std::size_t heights = bin(2, box.high[2]) + 1;
    std::vector<Row> rows(heights * (bin(1, box.high[1]) + 1));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        rows[r].y = box.low[1] + spacing * static_cast<double>(r / heights);
        rows[r].z = box.low[2] + spacing * static_cast<double>(r % heights);
    }
    const auto for_each = [&](const auto& visit) {
        for (std::size_t p = 0; p < sides.size(); ++p) {
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
        if (ice.failure_time.empty() || !(ice.failure_time[p] <= time) || !row.cracked()) return;
        if (row.rear < x && x < row.iceberg)
            row.first_failure = std::min<double>(row.first_failure, ice.failure_time[p]);
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

// Of the plane through the cracks of the rows; one row has none.
struct Plane {
    double angle = none;   // degrees, see Calving
    double misfit = none;  // m
};

Plane fit_plane(std::span<const Row> rows, int dimension) {
    std::vector<Eigen::Vector3d> places;
    for (const Row& row : rows) {
        if (row.cracked()) places.emplace_back(row.crack(), dimension == 3 ? row.y : 0.0, row.z);
    }
    if (places.size() < static_cast<std::size_t>(dimension)) return {};
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const auto& at : places) center += at / static_cast<double>(places.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& at : places) spread += (at - center) * (at - center).transpose();
    if (dimension == 2) spread(1, 1) = spread.trace();  // so that the normal lies in the slice
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(spread);
    Eigen::Vector3d normal = principal.eigenvectors().col(0);
    if (normal[0] < 0.0) normal = -normal;  // towards the front
    const double square = std::max(principal.eigenvalues()[0], 0.0) / static_cast<double>(places.size());
    return {std::atan2(std::hypot(normal[0], normal[1]), normal[2]) * 180.0 / std::numbers::pi,
            std::sqrt(square)};
}

}  // namespace

Calving measure_calving(const IceAtRest& ice, std::span<const Side> sides, double time,
                        const CalvingSettings& settings) {
    assert(ice.points.size() == 3 * sides.size() && ice.volume.size() == sides.size());
    const double spacing = settings.spacing;
    const Box box = bounds(ice.points);
    Calving calving{.time = time, .volume = 0.0};
    for (std::size_t p = 0; p < sides.size(); ++p) {
        if (sides[p] == Side::iceberg) calving.volume += ice.volume[p];
    }
    const auto rows = make_rows(ice, sides, box, spacing, time);
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
    const Plane plane = fit_plane(rows, settings.dimension);
    calving.plane_angle = plane.angle;
    calving.plane_misfit = plane.misfit;
    calving.foot_angle = std::atan2(calving.height, calving.length_top) * 180.0 / std::numbers::pi;
    find_start(rows, height, calving);
    return calving;
}

}  // namespace tidewater::analysis
