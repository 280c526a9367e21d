#include "analysis/surface_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "analysis/surface_line.h"
#include "core/parallel.h"
#include "core/spline.h"
#include "core/types.h"

namespace tidewater::analysis {
namespace {

constexpr double covering = 0.25;  // cells of solids on average

struct Drop {
    float x, y, z, volume;
};

bool is_water(const ParticleCloud& cloud, std::size_t p) {
    return cloud.material.empty() || static_cast<Material>(cloud.material[p]) == Material::water;
}

int cell_of(double coordinate, double cell_size, int count) {
    return std::clamp(static_cast<int>(std::floor(coordinate / cell_size)), 0, count - 1);
}

std::size_t column_of(const ParticleCloud& cloud, std::size_t p, const Lattice& lattice) {
    const int i = cell_of(cloud.points[3 * p], lattice.spacing, lattice.along);
    const int j = lattice.across > 1 ? cell_of(cloud.points[3 * p + 1], lattice.spacing, lattice.across) : 0;
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(lattice.along) * static_cast<std::size_t>(j);
}

// The water, column by column of cells, in the particles' order in each.
struct Columns {
    std::vector<std::size_t> start;  // of each column among the drops, and the end
    std::vector<Drop> drops;

    Columns(const ParticleCloud& cloud, const Lattice& lattice) : start(lattice.count() + 1, 0) {
        for (std::size_t p = 0; p < cloud.volume.size(); ++p) {
            if (is_water(cloud, p)) ++start[column_of(cloud, p, lattice) + 1];
        }
        std::partial_sum(start.begin(), start.end(), start.begin());
        drops.resize(start.back());
        std::vector<std::size_t> next(start.begin(), start.end() - 1);
        for (std::size_t p = 0; p < cloud.volume.size(); ++p) {
            if (!is_water(cloud, p)) continue;
            const float* point = cloud.points.data() + 3 * p;
            drops[next[column_of(cloud, p, lattice)]++] = {point[0], point[1], point[2], cloud.volume[p]};
        }
    }
};

struct Span {
    int first, last;
};

// The places within a cell of a coordinate.
Span places_near(double coordinate, const Lattice& lattice, int count) {
    const double at = coordinate / lattice.spacing - 0.5;
    return {std::max(static_cast<int>(std::ceil(at - 1.0)), 0),
            std::min(static_cast<int>(std::floor(at + 1.0)), count - 1)};
}

// The volume of solids within a cell of each place.
std::vector<float> solids_near(const ParticleCloud& cloud, const Lattice& lattice) {
    std::vector<float> volume(lattice.count(), 0.0f);
    for (std::size_t p = 0; p < cloud.volume.size(); ++p) {
        if (is_water(cloud, p)) continue;
        const Span along = places_near(cloud.points[3 * p], lattice, lattice.along);
        const Span across =
            lattice.across > 1 ? places_near(cloud.points[3 * p + 1], lattice, lattice.across) : Span{0, 0};
        for (int j = across.first; j <= across.last; ++j) {
            for (int i = along.first; i <= along.last; ++i)
                volume[static_cast<std::size_t>(i + lattice.along * j)] += cloud.volume[p];
        }
    }
    return volume;
}

// Adds the water of the columns around place (i, j) to its line.
void gather(const Columns& columns, const Lattice& lattice, int dimension, int i, int j,
            const LineSamples& samples, std::span<double> line) {
    const double x = lattice.x(i), y = lattice.y(j), cell = lattice.spacing;
    for (int b = std::max(j - 1, 0); b <= std::min(j + 1, lattice.across - 1); ++b) {
        const auto row = static_cast<std::size_t>(lattice.along) * static_cast<std::size_t>(b);
        const std::size_t first = columns.start[row + static_cast<std::size_t>(std::max(i - 1, 0))];
        const std::size_t end =
            columns.start[row + static_cast<std::size_t>(std::min(i + 1, lattice.along - 1)) + 1];
        for (std::size_t d = first; d < end; ++d) {
            const Drop& drop = columns.drops[d];
            double weight = quadratic_spline((drop.x - x) / cell);
            if (dimension == 3) weight *= quadratic_spline((drop.y - y) / cell);
            if (weight > 0.0) spread_on_line(drop.z, weight * drop.volume, cell, samples, line);
        }
    }
}

}  // namespace

Lattice cell_lattice(const Tank& tank) {
    const auto cells = [&](double size) { return static_cast<int>(size / tank.cell_size + 1e-9); };
    return {cells(tank.size[0]), tank.dimension == 3 ? cells(tank.size[1]) : 1, tank.cell_size};
}

std::vector<float> surface_field(const ParticleCloud& cloud, const Tank& tank, std::span<const float> bed) {
    const Lattice lattice = cell_lattice(tank);
    assert(bed.size() == lattice.count() && cloud.points.size() == 3 * cloud.volume.size());
    assert(cloud.material.empty() || cloud.material.size() == cloud.volume.size());
    const std::vector<float> solids = solids_near(cloud, lattice);
    const double covered = covering * tank.cell_size * std::pow(2.0 * tank.cell_size, tank.dimension - 1);
    const Columns columns(cloud, lattice);
    const LineSamples samples(tank);
    std::vector<float> elevation(lattice.count(), std::numeric_limits<float>::quiet_NaN());
    const auto look_at = [&](std::size_t at) {
        if (solids[at] > covered) return;
        const auto row = static_cast<std::size_t>(lattice.along);
        const int i = static_cast<int>(at % row), j = static_cast<int>(at / row);
        std::vector<double> line(samples.count, 0.0);
        gather(columns, lattice, tank.dimension, i, j, samples, line);
        const Place place{lattice.x(i), lattice.y(j), bed[at]};
        const double z = find_surface(line, samples, full_line(place, tank), place.bed, tank);
        elevation[at] = static_cast<float>(z - tank.still_level);
    };
    parallel_for(lattice.count(), look_at, 64);
    return elevation;
}

}  // namespace tidewater::analysis
