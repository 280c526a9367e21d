#include "geometry/seeding.h"

#include <openvdb/tools/Interpolation.h>

#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"

namespace tidewater::geometry {
namespace {

// Points that are placed by a map lie half a spacing, as the map stretches it, inside or outside; a level set
// between its voxels is off by less, but near a body's edges by enough to lose the points there.
constexpr double place_slack = 0.25;

// Lattice indices [begin, end) per axis that cover the level set.
template <int D>
struct Lattice {
    std::array<long, 3> begin{0, 0, 0}, end{1, 1, 1};  // x, y, z; in 2D y has one layer
    double spacing = 0.0;

    Lattice(const openvdb::FloatGrid& level_set, const Seeding& seeding)
        : spacing(seeding.cell_size / seeding.per_axis) {
        const auto box = level_set.evalActiveVoxelBoundingBox();
        const auto voxel = level_set.voxelSize();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (D == 2 && axis == 1) continue;
            const double per_voxel = voxel[static_cast<int>(axis)] / spacing;
            const long margin = static_cast<long>(std::ceil(seeding.margin / spacing)) + 1;
            begin[axis] = static_cast<long>(std::floor(box.min()[axis] * per_voxel)) - margin;
            end[axis] = static_cast<long>(std::ceil(box.max()[axis] * per_voxel)) + margin;
        }
    }

    Point at(long x, long y, long z) const {
        const auto along = [&](long n) { return (static_cast<double>(n) + 0.5) * spacing; };
        return {along(x), D == 2 ? 0.0 : along(y), along(z)};
    }
};

// A counter for the lattice point that does not depend on the extent of the level set.
std::uint64_t counter(long x, long y, long z) {
    const auto bits = [](long n) { return static_cast<std::uint64_t>(n + (1L << 20)) & 0x1fffffULL; };
    return bits(x) << 42 | bits(y) << 21 | bits(z);
}

}  // namespace

template <int D>
std::vector<Vector<D, double>> seed_points(const openvdb::FloatGrid& level_set, const Seeding& seeding) {
    std::vector<Vector<D, double>> points;
    if (level_set.empty()) return points;
    const Lattice<D> lattice(level_set, seeding);
    const auto slack = static_cast<float>(seeding.place ? place_slack * lattice.spacing : 0.0);
    std::vector<std::vector<Vector<D, double>>> of_slice(
        static_cast<std::size_t>(lattice.end[0] - lattice.begin[0]));
    parallel_for(of_slice.size(), [&](std::size_t slice) {
        const auto accessor = level_set.getConstAccessor();
        const openvdb::tools::GridSampler<openvdb::FloatGrid::ConstAccessor, openvdb::tools::BoxSampler>
            distance(accessor, level_set.transform());
        const long x = lattice.begin[0] + static_cast<long>(slice);
        for (long y = lattice.begin[1]; y < lattice.end[1]; ++y) {
            for (long z = lattice.begin[2]; z < lattice.end[2]; ++z) {
                const auto inside = [&](const Point& at) {
                    return distance.wsSample({at[0], at[1], at[2]}) < slack;
                };
                Point point = lattice.at(x, y, z);
                if (!seeding.place && !inside(point)) continue;
                for (int axis = 0; axis < 3 && seeding.jitter > 0.0; ++axis) {
                    const auto stream = 3 * seeding.stream + static_cast<std::uint64_t>(axis);
                    const double u = random_uniform(seeding.seed, stream, counter(x, y, z));
                    point[axis] += seeding.jitter * lattice.spacing * (u - 0.5);
                }
                if (seeding.place) point = seeding.place(point);
                if (seeding.place && !inside(point)) continue;
                if constexpr (D == 2)
                    of_slice[slice].emplace_back(point[0], point[2]);
                else
                    of_slice[slice].push_back(point);
            }
        }
    });
    for (const auto& slice : of_slice) points.insert(points.end(), slice.begin(), slice.end());
    return points;
}

template std::vector<Vector<2, double>> seed_points<2>(const openvdb::FloatGrid&, const Seeding&);
template std::vector<Vector<3, double>> seed_points<3>(const openvdb::FloatGrid&, const Seeding&);

}  // namespace tidewater::geometry
