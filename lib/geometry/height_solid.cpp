#include "geometry/height_solid.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace tidewater::geometry {
namespace {

// The steepest slope of the patches within `reach` lattice points of each point, along x and y.
std::vector<double> steepest_around(const HeightField& field, int reach) {
    std::vector<double> steepest(field.heights.size(), 0.0);
    const auto at = [&](int i, int j) -> std::size_t {
        return static_cast<std::size_t>(std::clamp(i, 0, field.nx - 1)) * static_cast<std::size_t>(field.ny) +
               static_cast<std::size_t>(std::clamp(j, 0, field.ny - 1));
    };
    for (int i = 0; i < field.nx; ++i) {
        for (int j = 0; j < field.ny;
             ++j) {  // of the edges that leave the point: no patch is steeper than two of them
            const double z = field.heights[at(i, j)];
            double along = 0.0, across = 0.0;
            for (const int side : {-1, 1}) {
                along = std::max(along, std::abs(field.heights[at(i + side, j)] - z));
                across = std::max(across, std::abs(field.heights[at(i, j + side)] - z));
            }
            steepest[at(i, j)] = std::hypot(along, across) / field.spacing;
        }
    }
    for (const bool along_x : {true, false}) {
        const std::vector<double> before = steepest;
        for (int i = 0; i < field.nx; ++i) {
            for (int j = 0; j < field.ny; ++j) {
                for (int m = -reach; m <= reach; ++m)
                    steepest[at(i, j)] =
                        std::max(steepest[at(i, j)], before[along_x ? at(i + m, j) : at(i, j + m)]);
            }
        }
    }
    return steepest;
}

}  // namespace

Solid below(const HeightField& heights) {
    struct Data {
        HeightField field;
        std::vector<double> steepest;
    };
    constexpr double far = 9.5, near = 3.5;  // spacings: above a leaf's half diagonal and its band; a band
    const auto data =
        std::make_shared<const Data>(heights, steepest_around(heights, static_cast<int>(far) + 2));
    return [data](const Point& p) {
        const HeightField& field = data->field;
        const auto nearest = [&](double place, int count) {
            return static_cast<std::size_t>(std::clamp(std::lround(place / field.spacing), 0L, count - 1L));
        };
        const double steepest = data->steepest[nearest(p[0], field.nx) * static_cast<std::size_t>(field.ny) +
                                               nearest(p[1], field.ny)];
        const double least = (p[2] - field.height(p[0], p[1])) / std::hypot(1.0, steepest);
        if (std::abs(least) >= near * field.spacing)
            return std::clamp(least, -far * field.spacing, far * field.spacing);
        const double searched = signed_distance(field, p, near * field.spacing);  // 0 about twisted patches
        return std::abs(searched) > std::abs(least) ? searched : least;
    };
}

}  // namespace tidewater::geometry
