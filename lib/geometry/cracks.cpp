#include "geometry/cracks.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"

namespace tidewater::geometry {
namespace {

constexpr long beyond = 4;          // r of sites around the region
constexpr std::size_t listed = 40;  // neighbours of a site
constexpr std::uint64_t site_stream = 0x637261636bULL, line_stream = site_stream + 3;

void check(const CrackSettings& s) {
    const auto require = [](bool right, const char* line) {
        if (!right) throw SceneError(std::string("cracks: ") + line);
    };
    require(s.dimension == 2 || s.dimension == 3, "dimension must be 2 or 3");
    require(s.cell_size > 0.0, "cell_size must be above 0");
    require(s.width >= 0.0 && s.width < 0.25 * s.cell_size,
            "width must be at least 0 and below a quarter of cell_size; make cracks thinner or cells larger");
    require(s.cohesion >= 0.0 && s.cohesion <= 1.0, "cohesion must lie between 0 and 1");
    require((s.region.low.array() <= s.region.high.array()).all(), "the region has no room");
}

// The lattice's cells around the region, [begin, begin + count) per axis; one site in each, in their order.
struct Lattice {
    std::array<long, 3> begin{0, 0, 0}, count{1, 1, 1};
    double edge;
    int dimension;

    explicit Lattice(const CrackSettings& s) : edge(s.cell_size), dimension(s.dimension) {
        for (int axis = 0; axis < 3; ++axis) {
            if (dimension == 2 && axis == 1) continue;
            const auto n = static_cast<std::size_t>(axis);
            begin[n] = static_cast<long>(std::floor(s.region.low[axis] / edge)) - beyond;
            count[n] = static_cast<long>(std::floor(s.region.high[axis] / edge)) + 1 + beyond - begin[n];
        }
    }

    std::size_t size() const { return static_cast<std::size_t>(count[0] * count[1] * count[2]); }

    std::uint32_t index(const std::array<long, 3>& cell) const {
        return static_cast<std::uint32_t>((cell[0] * count[1] + cell[1]) * count[2] + cell[2]);
    }

    std::array<long, 3> cell(std::size_t index) const {
        const auto n = static_cast<long>(index);
        return {n / (count[1] * count[2]), n / count[2] % count[1], n % count[2]};
    }

    // Counted from `begin`; the nearest one for points outside.
    std::array<long, 3> cell_at(const Point& point) const {
        std::array<long, 3> cell{0, 0, 0};
        for (std::size_t n = 0; n < 3; ++n) {
            const double place =
                std::floor(point[static_cast<long>(n)] / edge) - static_cast<double>(begin[n]);
            cell[n] = static_cast<long>(std::clamp(place, 0.0, static_cast<double>(count[n] - 1)));
        }
        return cell;
    }

    // Calls body(index) for all cells at most `steps` away along each axis.
    template <class Body>
    void around(const std::array<long, 3>& middle, long steps, const Body& body) const {
        const auto low = [&](std::size_t n) { return std::max(middle[n] - steps, 0L); };
        const auto high = [&](std::size_t n) { return std::min(middle[n] + steps, count[n] - 1); };
        for (long x = low(0); x <= high(0); ++x) {
            for (long y = low(1); y <= high(1); ++y) {
                for (long z = low(2); z <= high(2); ++z) body(index({x, y, z}));
            }
        }
    }
};

struct Neighbour {
    double distance;  // between the sites
    std::uint32_t site;
};

struct Nearest {
    std::uint32_t site;
    double squared;
};

double measure(const CrackSettings& s) {
    const Point size = s.region.high - s.region.low;
    return size[0] * size[2] * (s.dimension == 3 ? size[1] : 1.0);
}

}  // namespace

struct CrackFinder::Index {
    Lattice lattice;
    std::vector<Point> sites;
    // Of each lattice cell, the sites that may be the nearest of a point in it; of each site, its nearest.
    std::vector<std::vector<std::uint32_t>> candidates;
    std::vector<std::vector<Neighbour>> neighbours;

    explicit Index(const Cracks& cracks)
        : lattice(cracks.settings), sites(cracks.sites), candidates(sites.size()), neighbours(sites.size()) {
        parallel_for(
            sites.size(),
            [&](std::size_t n) {
                candidates[n] = find_candidates(lattice.cell(n));
                neighbours[n] = find_neighbours(n);
            },
            16);
    }

    // No point of the cell is farther from its nearest site than the least of all sites' farthest corners.
    std::vector<std::uint32_t> find_candidates(const std::array<long, 3>& cell) const {
        Point low;
        for (std::size_t n = 0; n < 3; ++n)
            low[static_cast<long>(n)] = lattice.edge * static_cast<double>(cell[n] + lattice.begin[n]);
        const Point half = 0.5 * lattice.edge * Point(1.0, lattice.dimension == 2 ? 0.0 : 1.0, 1.0);
        const auto from_middle = [&](std::uint32_t n) { return (sites[n] - low - half).cwiseAbs().eval(); };
        double bound = std::numeric_limits<double>::infinity();
        lattice.around(cell, 2, [&](std::uint32_t n) {
            bound = std::min(bound, (from_middle(n) + half).squaredNorm());
        });
        std::vector<std::uint32_t> found;
        lattice.around(cell, 2, [&](std::uint32_t n) {
            if ((from_middle(n) - half).cwiseMax(0.0).squaredNorm() <= bound) found.push_back(n);
        });
        return found;
    }

    std::vector<Neighbour> find_neighbours(std::size_t site) const {
        std::vector<Neighbour> found;
        lattice.around(lattice.cell(site), 2, [&](std::uint32_t n) {
            if (n != site) found.push_back({(sites[n] - sites[site]).norm(), n});
        });
        std::sort(found.begin(), found.end(),
                  [](const Neighbour& a, const Neighbour& b) { return a.distance < b.distance; });
        // Beyond two edges, some that are as near lie farther along the lattice.
        const auto far = std::find_if(found.begin(), found.end(), [&](const Neighbour& other) {
            return other.distance > 2.0 * lattice.edge;
        });
        found.erase(std::min(far, found.begin() + std::min<long>(listed, std::ssize(found))), found.end());
        found.shrink_to_fit();
        return found;
    }

    Point flat(const Point& point) const {
        return {point[0], lattice.dimension == 2 ? 0.0 : point[1], point[2]};
    }

    Nearest nearest(const Point& at) const {
        Nearest result{0, std::numeric_limits<double>::infinity()};
        for (const std::uint32_t n : candidates[lattice.index(lattice.cell_at(at))]) {
            const double squared = (sites[n] - at).squaredNorm();
            if (squared < result.squared) result = {n, squared};
        }
        return result;
    }

    double wall_distance(const Point& at) const {
        const auto [own, squared] = nearest(at);
        const double distance = std::sqrt(squared);
        double best = std::numeric_limits<double>::infinity();
        const auto look_at = [&](std::uint32_t site, double between) {
            best = std::min(best, ((sites[site] - at).squaredNorm() - squared) / (2.0 * between));
        };
        for (const Neighbour& other : neighbours[own]) {
            if (0.5 * other.distance - distance >= best) return best;
            look_at(other.site, other.distance);
        }
        lattice.around(lattice.cell_at(at), beyond, [&](std::uint32_t n) {
            if (n != own) look_at(n, (sites[n] - sites[own]).norm());
        });
        return best;
    }

    // Cells are convex: a line between two points of one crosses no wall.
    int walls_between(const Point& a, std::uint32_t cell_a, const Point& b, std::uint32_t cell_b,
                      int halvings) const {
        if (cell_a == cell_b) return 0;
        if (halvings == 0) return 1;
        const Point middle = 0.5 * (a + b);
        const std::uint32_t cell = nearest(middle).site;
        return walls_between(a, cell_a, middle, cell, halvings - 1) +
               walls_between(middle, cell, b, cell_b, halvings - 1);
    }
};

Cracks make_cracks(const CrackSettings& settings) {
    check(settings);
    Cracks cracks{settings, {}};
    const Lattice lattice(settings);
    cracks.sites.resize(lattice.size());
    const auto bits = [](long n) { return static_cast<std::uint64_t>(n) & 0x1fffffULL; };
    for (std::size_t n = 0; n < cracks.sites.size(); ++n) {
        std::array<long, 3> cell = lattice.cell(n);
        for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] += lattice.begin[axis];
        const std::uint64_t counter = bits(cell[0]) << 42 | bits(cell[1]) << 21 | bits(cell[2]);
        const auto place = [&](std::size_t axis) {
            return lattice.edge * (static_cast<double>(cell[axis]) +
                                   random_uniform(settings.seed, site_stream + axis, counter));
        };
        cracks.sites[n] = {place(0), settings.dimension == 2 ? 0.0 : place(1), place(2)};
    }
    return cracks;
}

CrackFinder::CrackFinder(const Cracks& cracks) : index_(std::make_unique<const Index>(cracks)) {}
CrackFinder::~CrackFinder() = default;
CrackFinder::CrackFinder(CrackFinder&&) noexcept = default;

double CrackFinder::wall_distance(const Point& point) const {
    return index_->wall_distance(index_->flat(point));
}

int CrackFinder::walls_between(const Point& a, const Point& b) const {
    return index_->walls_between(index_->flat(a), cell(a), index_->flat(b), cell(b), 16);
}

std::uint32_t CrackFinder::cell(const Point& point) const {
    return index_->nearest(index_->flat(point)).site;
}

namespace {

// Points per cell, from points evenly in the region.
struct Pieces {
    std::vector<std::uint32_t> points;
    double share = 0.0;  // of the region, of a point
};

Pieces count_pieces(const Cracks& cracks, const CrackFinder& finder) {
    const CrackSettings& s = cracks.settings;
    const Point size = s.region.high - s.region.low;
    const double step = s.cell_size / (s.dimension == 3 ? 8.0 : 16.0);
    std::array<std::size_t, 3> count{1, 1, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (s.dimension == 3 || axis != 1)
            count[axis] = std::max<std::size_t>(
                1, static_cast<std::size_t>(std::lround(size[static_cast<long>(axis)] / step)));
    }
    std::vector<std::atomic<std::uint32_t>> points(cracks.sites.size());
    parallel_for(count[0], [&](std::size_t x) {
        for (std::size_t y = 0; y < count[1]; ++y) {
            for (std::size_t z = 0; z < count[2]; ++z) {
                const auto along = [&](std::size_t n, std::size_t axis) {
                    const auto i = static_cast<long>(axis);
                    return s.region.low[i] +
                           size[i] * (static_cast<double>(n) + 0.5) / static_cast<double>(count[axis]);
                };
                points[finder.cell({along(x, 0), along(y, 1), along(z, 2)})] += 1;
            }
        }
    });
    return {{points.begin(), points.end()}, 1.0 / static_cast<double>(count[0] * count[1] * count[2])};
}

void measure_pieces(const Cracks& cracks, const CrackFinder& finder, CrackStatistics& result) {
    const int dimension = cracks.settings.dimension;
    const auto [points, share] = count_pieces(cracks, finder);
    std::vector<double> diameters;
    for (const std::uint32_t count : points) {
        if (count == 0) continue;
        const double volume = count * share * measure(cracks.settings);
        diameters.push_back(dimension == 3 ? std::cbrt(6.0 * volume / std::numbers::pi)
                                           : std::sqrt(4.0 * volume / std::numbers::pi));
    }
    result.pieces = diameters.size();
    double sum = 0.0, squares = 0.0;
    for (const double diameter : diameters) sum += diameter;
    result.diameter_mean = sum / static_cast<double>(diameters.size());
    for (const double diameter : diameters) squares += std::pow(diameter - result.diameter_mean, 2);
    result.diameter_deviation = std::sqrt(squares / static_cast<double>(diameters.size()));
    const auto [least, greatest] = std::minmax_element(diameters.begin(), diameters.end());
    result.diameter_least = *least;
    result.diameter_greatest = *greatest;
}

constexpr std::size_t lines = 250'000;

// Walls crossed per m of short lines, r/8, anywhere in the region in any direction.
double crossings(const Cracks& cracks, const CrackFinder& finder) {
    const CrackSettings& s = cracks.settings;
    const double length = 0.125 * s.cell_size;
    std::vector<int> crossed(lines);
    parallel_for(
        lines,
        [&](std::size_t n) {
            const auto u = [&](std::uint64_t stream) {
                return random_uniform(s.seed, line_stream + stream, n);
            };
            const Point middle =
                s.region.low + Point(u(0), u(1), u(2)).cwiseProduct(s.region.high - s.region.low);
            const double turn = 2.0 * std::numbers::pi * u(3);
            const double y = s.dimension == 3 ? 2.0 * u(4) - 1.0 : 0.0, level = std::sqrt(1.0 - y * y);
            const Point way = length * Point(level * std::cos(turn), y, level * std::sin(turn));
            crossed[n] = finder.walls_between(middle - 0.5 * way, middle + 0.5 * way);
        },
        256);
    double sum = 0.0;
    for (const int count : crossed) sum += count;
    return sum / (length * static_cast<double>(lines));
}

bool within(const CrackSettings& s, const Point& site) {
    for (int axis = 0; axis < 3; ++axis) {
        if (s.dimension == 2 && axis == 1) continue;
        if (site[axis] < s.region.low[axis] || site[axis] >= s.region.high[axis]) return false;
    }
    return true;
}

}  // namespace

CrackStatistics statistics(const Cracks& cracks, const CrackFinder& finder) {
    const CrackSettings& s = cracks.settings;
    CrackStatistics result;
    for (const Point& site : cracks.sites) result.cells += within(s, site);
    const double volume = measure(s);
    if (result.cells > 0)
        result.cell_size = std::pow(volume / static_cast<double>(result.cells), 1.0 / s.dimension);
    measure_pieces(cracks, finder, result);
    result.wall_density = (s.dimension == 3 ? 2.0 : 0.5 * std::numbers::pi) * crossings(cracks, finder);
    result.crack_volume = result.wall_density * s.width * volume;
    return result;
}

}  // namespace tidewater::geometry
