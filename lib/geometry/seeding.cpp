#include "geometry/seeding.h"

#include <openvdb/tools/Interpolation.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "core/random.h"
#include "geometry/blue_noise.h"

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

    std::size_t slice_size() const {
        return static_cast<std::size_t>((end[1] - begin[1]) * (end[2] - begin[2]));
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

// Cells of a tile per axis.
template <int D>
constexpr int tile_cells = D == 2 ? 16 : 6;

// Where the points of the lattice are put.
template <int D>
class Places {
public:
    Places(const Lattice<D>& lattice, const Seeding& seeding) : lattice_(lattice), seeding_(seeding) {
        if (seeding.pattern == SeedPattern::blue_noise)
            tile_ = make_blue_noise_tile<D>(tile_cells<D> * seeding.per_axis, seeding.seed);
    }

    Point operator()(long x, long y, long z) const {
        Point point = lattice_.at(x, y, z);
        if (seeding_.pattern == SeedPattern::blue_noise) {
            move_by_tile(x, y, z, point);
        } else if (seeding_.jitter > 0.0) {
            for (int axis = 0; axis < 3; axis += 4 - D) {
                const auto stream = 3 * seeding_.stream + static_cast<std::uint64_t>(axis);
                const double u = random_uniform(seeding_.seed, stream, counter(x, y, z));
                point[axis] += seeding_.jitter * lattice_.spacing * (u - 0.5);
            }
        }
        return seeding_.place ? seeding_.place(point) : point;
    }

private:
    void move_by_tile(long x, long y, long z, Point& point) const {
        if constexpr (D == 2) {
            const auto& offset = tile_.at({x, z});
            point += lattice_.spacing * Point(offset[0], 0.0, offset[1]);
        } else {
            point += lattice_.spacing * tile_.at({x, y, z});
        }
    }

    const Lattice<D>& lattice_;
    const Seeding& seeding_;
    BlueNoiseTile<D> tile_;
};

// Whether points lie less than `slack` outside of a level set. Between voxels the distance is interpolated;
// where the band of distances ends two voxels or more away, its end's sign says enough.
class Inside {
public:
    Inside(const openvdb::FloatGrid& level_set, float slack)
        : transform_(level_set.transform()),
          accessor_(level_set.getConstAccessor()),
          slack_(slack),
          beyond_(level_set.background() >= 2.0 * level_set.voxelSize()[0]
                      ? level_set.background()
                      : std::numeric_limits<float>::infinity()) {}

    bool operator()(const Point& point) const {
        const openvdb::Vec3d at = transform_.worldToIndex({point[0], point[1], point[2]});
        const float near = accessor_.getValue(openvdb::Coord::floor(at));
        if (std::abs(near) >= beyond_) return near < 0.0F;
        return openvdb::tools::BoxSampler::sample(accessor_, at) < slack_;
    }

private:
    const openvdb::math::Transform& transform_;
    openvdb::FloatGrid::ConstAccessor accessor_;
    float slack_, beyond_;
};

// Which points of a slice of the lattice, x = const, are to be.
struct Slice {
    long x = 0;
    std::vector<bool> marks;  // y slower
    std::size_t count = 0, first = 0;
};

// Calls body(n, y, z) for the slice's n-th point.
template <int D, class Body>
void for_slice(const Lattice<D>& lattice, const Body& body) {
    std::size_t n = 0;
    for (long y = lattice.begin[1]; y < lattice.end[1]; ++y) {
        for (long z = lattice.begin[2]; z < lattice.end[2]; ++z, ++n) body(n, y, z);
    }
}

template <int D>
void mark(const Lattice<D>& lattice, const Places<D>& places, const Seeding& seeding, const Inside& inside,
          Slice& slice) {
    slice.marks.resize(lattice.slice_size());
    for_slice(lattice, [&](std::size_t n, long y, long z) {
        if (!seeding.place && !inside(lattice.at(slice.x, y, z))) return;
        if (seeding.place || seeding.keep) {
            const Point point = places(slice.x, y, z);
            if (seeding.place && !inside(point)) return;
            if (seeding.keep && !seeding.keep(point)) return;
        }
        slice.marks[n] = true;
        ++slice.count;
    });
}

template <int D>
void fill(const Lattice<D>& lattice, const Places<D>& places, const Slice& slice,
          std::vector<Vector<D, double>>& points) {
    std::size_t next = slice.first;
    for_slice(lattice, [&](std::size_t n, long y, long z) {
        if (!slice.marks[n]) return;
        const Point point = places(slice.x, y, z);
        if constexpr (D == 2)
            points[next++] = {point[0], point[2]};
        else
            points[next++] = point;
    });
}

}  // namespace

// Marked first, so that every slice knows where its points go, and nothing is held twice.
template <int D>
std::vector<Vector<D, double>> seed_points(const openvdb::FloatGrid& level_set, const Seeding& seeding) {
    if (level_set.empty()) return {};
    const Lattice<D> lattice(level_set, seeding);
    const Places<D> places(lattice, seeding);
    const auto slack = static_cast<float>(seeding.place ? place_slack * lattice.spacing : 0.0);
    std::vector<Slice> slices(static_cast<std::size_t>(lattice.end[0] - lattice.begin[0]));
    parallel_for(slices.size(), [&](std::size_t n) {
        slices[n].x = lattice.begin[0] + static_cast<long>(n);
        mark(lattice, places, seeding, Inside(level_set, slack), slices[n]);
    });
    std::size_t total = 0;
    for (Slice& slice : slices) {
        slice.first = total;
        total += slice.count;
    }
    std::vector<Vector<D, double>> points(total);
    parallel_for(slices.size(), [&](std::size_t n) { fill(lattice, places, slices[n], points); });
    return points;
}

template std::vector<Vector<2, double>> seed_points<2>(const openvdb::FloatGrid&, const Seeding&);
template std::vector<Vector<3, double>> seed_points<3>(const openvdb::FloatGrid&, const Seeding&);

}  // namespace tidewater::geometry
