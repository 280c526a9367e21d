#include "analysis/surface_speed.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/types.h"

namespace tidewater::analysis {
namespace {

// The place nearest to `at` along one axis; nothing farther than half a cell from all.
std::optional<std::size_t> nearest(std::span<const double> places, double at, double cell_size) {
    if (places.size() == 1) return 0;
    const double steps = std::round((at - places.front()) / cell_size);
    if (!(steps >= 0.0) || steps >= static_cast<double>(places.size())) return {};
    return static_cast<std::size_t>(steps);
}

}  // namespace

std::vector<float> surface_speed(const ParticleCloud& cloud, std::span<const float> velocity,
                                 const PlaceGrid& places) {
    std::vector<std::array<double, 4>> sum(places.level.size());  // volume, and it times the velocity
    for (std::size_t p = 0; p < cloud.volume.size(); ++p) {
        if (!cloud.material.empty() && static_cast<Material>(cloud.material[p]) != Material::water) continue;
        const auto i = nearest(places.x, static_cast<double>(cloud.points[3 * p]), places.cell_size);
        const auto j = nearest(places.y, static_cast<double>(cloud.points[3 * p + 1]), places.cell_size);
        if (!i || !j) continue;
        const std::size_t place = *i + places.x.size() * *j;
        const double off = static_cast<double>(cloud.points[3 * p + 2] - places.level[place]);
        if (!(std::abs(off) <= places.cell_size)) continue;
        const double volume = static_cast<double>(cloud.volume[p]);
        sum[place][0] += volume;
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum[place][axis + 1] += volume * static_cast<double>(velocity[3 * p + axis]);
    }
    std::vector<float> speed;
    for (const auto& [volume, x, y, z] : sum) {
        speed.push_back(volume > 0.0 ? static_cast<float>(std::hypot(x, y, z) / volume)
                                     : std::numeric_limits<float>::quiet_NaN());
    }
    return speed;
}

}  // namespace tidewater::analysis
