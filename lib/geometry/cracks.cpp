#include "geometry/cracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"

namespace tidewater::geometry {
namespace {

constexpr long beyond = 4;          // r of sites around the region
constexpr std::size_t listed = 40;  // neighbours of a site
constexpr std::uint64_t site_stream = 0x637261636bULL;

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

}  // namespace tidewater::geometry
