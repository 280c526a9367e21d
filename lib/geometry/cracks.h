// Cracks: ice broken into the cells of a Voronoi tessellation, apart by the walls between them.
//
// One site per cell of a lattice of edge r, anywhere within it; a point belongs to its nearest site, and the
// walls lie halfway between sites that share one. From a point whose nearest site is s1, at d1, the wall
// towards site s, at d, is (d² − d1²) / (2 |s − s1|) away. Sites depend on the seed and their lattice cell
// alone, so that a larger region has the same cracks, and cracks thinner than a voxel or a cell survive: they
// are kept as sites, and every particle asks.
//
// Test: tests/unit/geometry/cracks_test.cpp
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/box.h"

namespace tidewater::geometry {

struct CrackSettings {
    double cell_size = 80.0;  // r, m
    double width = 1.0;       // of the cracks, m, below r/4
    double cohesion = 0.0;    // share of the strength left in them, 0 to 1; kept here for the user
    Extent region{Point::Zero(), Point::Zero()};
    int dimension = 3;  // 2: the plane y = 0, whose sites lie in it
    std::uint64_t seed = 1;
};

// All sites of lattice cells that come within 4 r of the region: more than any wall in it depends on. (The
// nearest site of a point is at most √3 r away, so no cell reaches farther than that from its site, and no
// wall is due to a site more than 2 √3 r away.)
struct Cracks {
    CrackSettings settings;
    std::vector<Point> sites;  // m; x slowest, z fastest
};

// Throws SceneError if a number is out of range.
Cracks make_cracks(const CrackSettings& settings);

// Answers for points in the region, from many threads, exactly. In 2D their y does not count. The nearest
// site is one of those listed for the point's lattice cell. The neighbours of that site are gone through by
// distance until no farther one can have a nearer wall, |s − s1| / 2 − d1 being as near as the wall of s can
// be; should the list end before, all sites within 4 r are. Time: 160 to 240 ns in 3D for points in
// order, twice that at random, 100 ns in 2D; memory: 1 kB per site in 3D.
class CrackFinder {
public:
    explicit CrackFinder(const Cracks& cracks);
    ~CrackFinder();
    CrackFinder(CrackFinder&&) noexcept;

    double wall_distance(const Point& point) const;  // m, to the middle of the nearest crack
    std::uint32_t cell(const Point& point) const;    // index of the nearest site
    // How many walls the straight line from a to b crosses; three or more within 2⁻¹⁶ of it count as one.
    int walls_between(const Point& a, const Point& b) const;

private:
    struct Index;
    std::unique_ptr<const Index> index_;
};

struct CrackStatistics {
    std::size_t cells = 0;   // sites in the region
    double cell_size = 0.0;  // (volume / cells)^(1/D), m; r on average
    // Of the pieces that the region is cut into, diameters of spheres (2D: discs) of their volume, m, from
    // points r/8 (2D: r/16) apart.
    std::size_t pieces = 0;
    double diameter_mean = 0.0, diameter_deviation = 0.0, diameter_least = 0.0, diameter_greatest = 0.0;
    // Walls' area per volume, 1/m (2D: length per area): by Crofton's formula, 2 (2D: π/2) times the walls
    // that lines in all directions cross per m. Within about 0.5 %.
    double wall_density = 0.0;
    double crack_volume = 0.0;  // wall_density · width · volume, m³; off by about width/r, where cracks meet
};

CrackStatistics statistics(const Cracks& cracks, const CrackFinder& finder);

}  // namespace tidewater::geometry
