#include "geometry/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/parallel.h"

namespace tidewater::geometry {
namespace {

// Share of a cell that lies below a plane at the body's value and slope in its middle; the slope is found by
// differences, since a body's function may rise more slowly than the distance.
double share_below(const Solid& solid, double value, const Point& middle, const Point& edges, int dimension) {
    double slope2 = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (dimension == 2 && axis == 1) continue;
        const double step = 0.25 * edges[axis];
        const double rise =
            solid(middle + step * Point::Unit(axis)) - solid(middle - step * Point::Unit(axis));
        slope2 += rise * rise / (4.0 * step * step);
    }
    if (slope2 == 0.0) return value <= 0.0 ? 1.0 : 0.0;
    const double width = std::pow(edges[0] * edges[2] * (dimension == 3 ? edges[1] : 1.0), 1.0 / dimension);
    return std::clamp(0.5 - value / (std::sqrt(slope2) * width), 0.0, 1.0);
}

// Share of a cell (its middle, its edges) that is inside.
double inside_share(const Solid& solid, const Point& middle, const Point& edges, int levels, int dimension) {
    const double distance = solid(middle);
    const double reach = 0.5 * (dimension == 3 ? edges.norm() : std::hypot(edges[0], edges[2]));
    if (distance <= -reach) return 1.0;
    if (distance >= reach) return 0.0;
    if (levels == 0) return share_below(solid, distance, middle, edges, dimension);
    double sum = 0.0;
    const int halves = 1 << dimension;
    for (int n = 0; n < halves; ++n) {
        const Point side(n & 1 ? 0.25 : -0.25, dimension == 3 ? (n & 4 ? 0.25 : -0.25) : 0.0,
                         n & 2 ? 0.25 : -0.25);
        sum += inside_share(solid, middle + side.cwiseProduct(edges), 0.5 * edges, levels - 1, dimension);
    }
    return sum / halves;
}

}  // namespace

Solid box_solid(const Box& box) {
    return [box](const Point& point) { return signed_distance(box, point); };
}

Solid prism(Polygon outline, double from_y, double to_y) {
    return [outline = std::move(outline), from_y, to_y](const Point& point) {
        const double across = std::max(from_y - point[1], point[1] - to_y);
        const double along = signed_distance(outline, {point[0], point[2]});
        return std::max(along, across);
    };
}

Solid common(Solid a, Solid b) {
    return [a = std::move(a), b = std::move(b)](const Point& point) { return std::max(a(point), b(point)); };
}

Solid without(Solid from, Solid taken) {
    if (!taken) return from;
    return [from = std::move(from), taken = std::move(taken)](const Point& point) {
        return std::max(from(point), -taken(point));
    };
}

double volume(const Solid& solid, const Extent& extent, double cell, int levels, int dimension) {
    std::array<std::size_t, 3> count{1, 1, 1};
    Point edges = Point::Zero(), low = extent.low;
    double cell_volume = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (dimension == 2 && axis == 1) {
            low[1] = 0.0;
            continue;
        }
        const double length = extent.high[axis] - extent.low[axis];
        if (length <= 0.0) return 0.0;
        auto& n = count[static_cast<std::size_t>(axis)];
        n = static_cast<std::size_t>(std::max(std::ceil(length / cell - 1e-6), 1.0));
        edges[axis] = length / static_cast<double>(n);
        cell_volume *= edges[axis];
    }
    std::vector<double> shares(count[0], 0.0);  // of the slices along x
    parallel_for(count[0], [&](std::size_t x) {
        for (std::size_t y = 0; y < count[1]; ++y) {
            for (std::size_t z = 0; z < count[2]; ++z) {
                const auto place = [](std::size_t n) { return static_cast<double>(n) + 0.5; };
                const Point middle =
                    low + Point(place(x), dimension == 3 ? place(y) : 0.0, place(z)).cwiseProduct(edges);
                shares[x] += inside_share(solid, middle, edges, levels, dimension);
            }
        }
    });
    double sum = 0.0;
    for (const double share : shares) sum += share;
    return cell_volume * sum;
}

}  // namespace tidewater::geometry
