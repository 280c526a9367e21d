// The water surface from a cloud of particles, finer than a cell.
//
// The volume fraction φ on a vertical line is the particles' volume spread with quadratic B-splines N of
// width Δx,
//     φ(z) = Σ_p V_p N((x_p - x)/Δx) N((y_p - y)/Δx) N((z_p - z)/Δx) / (Δx^D c(x) c(y) c(z)),
// where c is the share of the spline that lies within the tank, along z above the bed at the place, so that
// walls and bed do not thin the water, and the factors in y are present in 3D only. N is centred on the line
// itself: a place need not be a grid node. φ is sampled every Δx/4 (coarser, interpolating the curved flank
// of φ would err by up to 0.05 Δx). From the bed of the place upward, the surface is where φ first falls
// through one half, between two samples linearly: what lies above a gap, such as spray or the crest of a
// breaker, does not count.
//
// Accuracy on still water, at any level between cell lines and up to the walls (surface_test.cpp): 0.004 Δx
// with 2 × 2 particles per cell in rows; with jitter the greatest error grows to 0.05 Δx at 0.2 of a
// particle's own share and 0.26 Δx (standard deviation 0.07) at all of it, which is the roughness of that
// cloud. Where the bed slopes the same holds from a cell of water on. Within Δx of a wall a slope s adds up
// to 0.3 s Δx, since half of the spline is cut.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tidewater::analysis {

// Flat arrays, one entry per particle; only particles of material water count.
struct ParticleCloud {
    std::span<const float> points;           // m, (x, y, z) per particle; y is not read in 2D
    std::span<const float> volume;           // m³ (2D: m²), at rest
    std::span<const std::uint8_t> material;  // numbers of core's Material; empty: all are water
};

struct Tank {
    int dimension = 2;  // 2 or 3
    std::array<double, 3>
        size{};              // m, (x, y, z); the tank is the box from the origin to size; y is not read in 2D
    double cell_size = 0.0;  // Δx > 0, m
    double still_level = 0.0;  // z of the still water surface, m
};

struct Place {
    double x = 0.0;    // m
    double y = 0.0;    // m, not read in 2D
    double bed = 0.0;  // height of the ground, m; what lies below is not looked at
};

// Particles farther than this many cells from a place in x or in y do not count there, so that a caller who
// has more may leave them out.
inline constexpr double surface_reach = 1.5;

// η, the surface's height above still_level in m, at each place; NaN where there is no water on the bed.
// Places may lie anywhere in the tank and in any order. Time and memory grow as particles + places; the sums
// are taken in the particles' order.
std::vector<double> surface_elevation(const ParticleCloud& cloud, const Tank& tank,
                                      std::span<const Place> places);

}  // namespace tidewater::analysis
