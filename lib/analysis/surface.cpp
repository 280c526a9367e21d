#include "analysis/surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "core/types.h"

namespace tidewater::analysis {
namespace {

constexpr double samples_per_cell = 4.0;

// The quadratic B-spline; u in cells.
double spline(double u) {
    const double distance = std::abs(u);
    if (distance < 0.5) return 0.75 - u * u;
    return distance < 1.5 ? 0.5 * (1.5 - distance) * (1.5 - distance) : 0.0;
}

// Its integral from minus infinity to u.
double spline_integral(double u) {
    if (u <= -1.5) return 0.0;
    if (u <= -0.5) return (u + 1.5) * (u + 1.5) * (u + 1.5) / 6.0;
    if (u <= 0.5) return 0.5 + 0.75 * u - u * u * u / 3.0;
    return u < 1.5 ? 1.0 - (1.5 - u) * (1.5 - u) * (1.5 - u) / 6.0 : 1.0;
}

// c: the share of the spline centred at `center` that lies in [low, high].
double share_inside(double center, double low, double high, double cell_size) {
    return spline_integral((high - center) / cell_size) - spline_integral((low - center) / cell_size);
}

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

// φ on the vertical line of every place, not yet divided by Δx^D and the shares inside.
struct Lines {
    double spacing;       // m, between samples
    std::size_t samples;  // per line; sample k is at z = k · spacing
    std::vector<double> volume;

    Lines(const Tank& tank, std::size_t places)
        : spacing(tank.cell_size / samples_per_cell),
          samples(static_cast<std::size_t>(std::ceil(tank.size[2] / spacing - 1e-9)) + 1),
          volume(places * samples, 0.0) {}

    void spread(std::size_t place, double z, double amount, double cell_size) {
        const double reach = 1.5 * cell_size, top = static_cast<double>(samples - 1);
        if (z + reach < 0.0 || (z - reach) / spacing > top) return;
        const auto first = static_cast<std::size_t>(std::max(std::ceil((z - reach) / spacing), 0.0));
        const auto last = static_cast<std::size_t>(std::min(std::floor((z + reach) / spacing), top));
        double* line = volume.data() + place * samples;
        for (std::size_t k = first; k <= last; ++k) {
            line[k] += amount * spline((z - static_cast<double>(k) * spacing) / cell_size);
        }
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
            double weight = spline((x - places[place].x) / tank.cell_size);
            if (tank.dimension == 3) weight *= spline((y - places[place].y) / tank.cell_size);
            if (weight > 0.0) lines.spread(place, z, weight * cloud.volume[p], tank.cell_size);
        }
    }
    return lines;
}

// z where φ, from the bed upward, first falls through one half.
double find_surface(std::span<const double> volume, double spacing, double full, double bed,
                    const Tank& tank) {
    double below = 0.0;
    const auto first = static_cast<std::size_t>(std::ceil(std::max(bed, 0.0) / spacing - 1e-9));
    for (std::size_t k = first; k < volume.size(); ++k) {
        const double z = std::min(static_cast<double>(k) * spacing, tank.size[2]);
        const double fraction = volume[k] / (full * share_inside(z, bed, tank.size[2], tank.cell_size));
        if (below >= 0.5 && fraction < 0.5) {
            return z - spacing * (0.5 - fraction) / (below - fraction);
        }
        below = fraction;
    }
    return below >= 0.5 ? tank.size[2] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<double> surface_elevation(const ParticleCloud& cloud, const Tank& tank,
                                      std::span<const Place> places) {
    assert(tank.cell_size > 0.0 && (tank.dimension == 2 || tank.dimension == 3));
    assert(cloud.points.size() == 3 * cloud.volume.size());
    assert(cloud.material.empty() || cloud.material.size() == cloud.volume.size());
    const Lines lines = spread_volume(cloud, tank, places);
    std::vector<double> elevation;
    for (std::size_t i = 0; i < places.size(); ++i) {
        double full = std::pow(tank.cell_size, tank.dimension);
        full *= share_inside(places[i].x, 0.0, tank.size[0], tank.cell_size);
        if (tank.dimension == 3) full *= share_inside(places[i].y, 0.0, tank.size[1], tank.cell_size);
        const auto line = std::span(lines.volume).subspan(i * lines.samples, lines.samples);
        elevation.push_back(find_surface(line, lines.spacing, full, places[i].bed, tank) - tank.still_level);
    }
    return elevation;
}

}  // namespace tidewater::analysis
