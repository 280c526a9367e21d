#include "analysis/surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "analysis/surface_line.h"
#include "core/spline.h"
#include "core/types.h"

namespace tidewater::analysis {
namespace {

// Places in the order of x, and where each column of cells starts among them.
class PlaceBins {
public:
    PlaceBins(std::span<const Place> places, const Tank& tank)
        : places_(places), cell_size_(tank.cell_size), order_(places.size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(),
                         [&](std::size_t a, std::size_t b) { return places[a].x < places[b].x; });
        const auto columns = static_cast<std::size_t>(std::ceil(tank.size[0] / cell_size_)) + 1;
        start_.assign(columns + 1, 0);
        for (const Place& place : places) ++start_[column_of(place.x) + 1];
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
    }

    // The indices of all places that x can reach, and some more.
    std::span<const std::size_t> near(double x) const {
        const std::size_t column = column_of(x), columns = start_.size() - 1;
        const std::size_t first = start_[column < 2 ? 0 : column - 2];
        const std::size_t last = start_[std::min(column + 3, columns)];
        return std::span(order_).subspan(first, last - first);
    }

private:
    std::size_t column_of(double x) const {
        const double last = static_cast<double>(start_.size() - 2);
        return static_cast<std::size_t>(std::clamp(x / cell_size_, 0.0, last));
    }

    std::span<const Place> places_;
    double cell_size_;
    std::vector<std::size_t> order_;
    std::vector<std::size_t> start_;
};

// φ on the vertical line of every place, one behind the other.
struct Lines {
    LineSamples samples;
    std::vector<double> volume;

    Lines(const Tank& tank, std::size_t places) : samples(tank), volume(places * samples.count, 0.0) {}

    std::span<double> line(std::size_t place) {
        return std::span(volume).subspan(place * samples.count, samples.count);
    }
};

Lines spread_volume(const ParticleCloud& cloud, const Tank& tank, std::span<const Place> places) {
    Lines lines(tank, places.size());
    const PlaceBins bins(places, tank);
    for (std::size_t p = 0; p < cloud.volume.size(); ++p) {
        if (!cloud.material.empty() && cloud.material[p] != static_cast<std::uint8_t>(Material::water))
            continue;
        const double x = cloud.points[3 * p], y = cloud.points[3 * p + 1], z = cloud.points[3 * p + 2];
        for (const std::size_t place : bins.near(x)) {
            double weight = quadratic_spline((x - places[place].x) / tank.cell_size);
            if (tank.dimension == 3) weight *= quadratic_spline((y - places[place].y) / tank.cell_size);
            if (weight > 0.0)
                spread_on_line(z, weight * cloud.volume[p], tank.cell_size, lines.samples, lines.line(place));
        }
    }
    return lines;
}

}  // namespace

std::vector<double> surface_elevation(const ParticleCloud& cloud, const Tank& tank,
                                      std::span<const Place> places) {
    assert(tank.cell_size > 0.0 && (tank.dimension == 2 || tank.dimension == 3));
    assert(cloud.points.size() == 3 * cloud.volume.size());
    assert(cloud.material.empty() || cloud.material.size() == cloud.volume.size());
    Lines lines = spread_volume(cloud, tank, places);
    std::vector<double> elevation;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double z =
            find_surface(lines.line(i), lines.samples, full_line(places[i], tank), places[i].bed, tank);
        elevation.push_back(z - tank.still_level);
    }
    return elevation;
}

}  // namespace tidewater::analysis
