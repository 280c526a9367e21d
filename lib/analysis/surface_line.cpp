#include "analysis/surface_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/spline.h"

namespace tidewater::analysis {
namespace {

constexpr double samples_per_cell = 4.0;

}  // namespace

double spline_share(double center, double low, double high, double cell_size) {
    return quadratic_spline_integral((high - center) / cell_size) -
           quadratic_spline_integral((low - center) / cell_size);
}

LineSamples::LineSamples(const Tank& tank)
    : spacing(tank.cell_size / samples_per_cell),
      count(static_cast<std::size_t>(std::ceil(tank.size[2] / spacing - 1e-9)) + 1) {}

void spread_on_line(double z, double amount, double cell_size, const LineSamples& samples,
                    std::span<double> line) {
    const double reach = 1.5 * cell_size, spacing = samples.spacing;
    const double top = static_cast<double>(samples.count - 1);
    if (z + reach < 0.0 || (z - reach) / spacing > top) return;
    const auto first = static_cast<std::size_t>(std::max(std::ceil((z - reach) / spacing), 0.0));
    const auto last = static_cast<std::size_t>(std::min(std::floor((z + reach) / spacing), top));
    for (std::size_t k = first; k <= last; ++k)
        line[k] += amount * quadratic_spline((z - static_cast<double>(k) * spacing) / cell_size);
}

double full_line(const Place& place, const Tank& tank) {
    double full = std::pow(tank.cell_size, tank.dimension);
    full *= spline_share(place.x, 0.0, tank.size[0], tank.cell_size);
    if (tank.dimension == 3) full *= spline_share(place.y, 0.0, tank.size[1], tank.cell_size);
    return full;
}

double find_surface(std::span<const double> line, const LineSamples& samples, double full, double bed,
                    const Tank& tank) {
    const double spacing = samples.spacing;
    double below = 0.0;
    const auto first = static_cast<std::size_t>(std::ceil(std::max(bed, 0.0) / spacing - 1e-9));
    for (std::size_t k = first; k < line.size(); ++k) {
        const double z = std::min(static_cast<double>(k) * spacing, tank.size[2]);
        const double fraction = line[k] / (full * spline_share(z, bed, tank.size[2], tank.cell_size));
        if (below >= 0.5 && fraction < 0.5) {
            return z - spacing * (0.5 - fraction) / (below - fraction);
        }
        below = fraction;
    }
    return below >= 0.5 ? tank.size[2] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tidewater::analysis
