#include "geometry/box.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"

namespace tidewater::geometry {

using Corner = Vector<2, double>;  // (x, z)

double signed_distance(const Box& box, const Point& point) {
    const Point from = point - box.center;
    const double c = std::cos(box.angle), s = std::sin(box.angle);
    const Point own(c * from[0] + s * from[2], from[1], -s * from[0] + c * from[2]);
    const Point beyond = own.cwiseAbs() - box.half_size;
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

double shared_area(const Box& turned, const Box& upright) {
    const auto all = corners(turned);
    Polygon polygon(all.begin(), all.end());
    for (const int axis : {0, 1}) {
        const int axis3 = 2 * axis;
        polygon = clipped(polygon, axis, 1.0, upright.center[axis3] + upright.half_size[axis3]);
        polygon = clipped(polygon, axis, -1.0, upright.half_size[axis3] - upright.center[axis3]);
    }
    return area(polygon);
}

std::array<Vector<2, double>, 4> corners(const Box& box) {
    const double c = std::cos(box.angle), s = std::sin(box.angle);
    const auto corner = [&](double x, double z) {
        const double along = x * box.half_size[0], across = z * box.half_size[2];
        return Corner(box.center[0] + c * along - s * across, box.center[2] + s * along + c * across);
    };
    return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

Point reach(const Box& box) {
    const double c = std::abs(std::cos(box.angle)), s = std::abs(std::sin(box.angle));
    return {c * box.half_size[0] + s * box.half_size[2], box.half_size[1],
            s * box.half_size[0] + c * box.half_size[2]};
}

double separation(const Box& a, const Box& b) {
    double apart = std::abs(a.center[1] - b.center[1]) - a.half_size[1] - b.half_size[1];
    const auto from = corners(a), to = corners(b);
    for (const double angle : {a.angle, b.angle}) {
        const double c = std::cos(angle), s = std::sin(angle);
        for (const Corner& axis : {Corner(c, s), Corner(-s, c)}) {
            double reach = 0.0;
            for (const auto* box : {&from, &to}) {
                const Corner middle = 0.5 * ((*box)[0] + (*box)[2]);
                reach +=
                    std::max(std::abs(axis.dot((*box)[0] - middle)), std::abs(axis.dot((*box)[1] - middle)));
            }
            const Corner between(b.center[0] - a.center[0], b.center[2] - a.center[2]);
            apart = std::max(apart, std::abs(axis.dot(between)) - reach);
        }
    }
    return apart;
}

double area_below(const Box& box, double z) {
    const auto all = corners(box);
    return area_below(Polygon(all.begin(), all.end()), z);
}

double floating_height(const Box& box, double level, double share) {
    const double whole = 4.0 * box.half_size[0] * box.half_size[2], half = reach(box)[2];
    double low = level - half, high = level + half;  // all of it and nothing of it in the water
    if (share <= 0.0) return high;
    if (share >= 1.0) return low;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        Box there = box;
        there.center[2] = middle;
        (area_below(there, level) > share * whole ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace tidewater::geometry
