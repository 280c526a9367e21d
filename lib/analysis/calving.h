// The first iceberg: when it came off, how long it is, and where its crack began.
//
// Everything is measured in the ice at rest, where a crack is a band of particles that fail, each at its own
// time; so the times are exact to a step of the simulation, however far apart its frames are. At time t two
// particles are connected as fragments.h says, if both fail later than t or never.
//
// The first detachment is the least time at which a part of the ice, of at least smallest_share, is left
// without a connection to the rear; parts that come off smaller, such as the toe that is crushed, are crumbs
// and no icebergs. It is found backward: the particles are added in the order of decreasing failure time, and
// the last time at which such a part meets the rear's part is the detachment. The iceberg is the part as it
// was just after.
//
// Rows are the lines along x that a particle spacing in z, in 3D also in y, makes. In each row the crack lies
// midway between the rear's part and the iceberg, so that either side gets half of what failed between them.
// The iceberg's length is the distance from the crack to the ice's own front at that height, averaged over
// the rows: the volume between both, over height and width. What is crushed at the toe still counts as
// length; rows in which the iceberg has nothing left do not count.
#pragma once

#include <optional>
#include <span>

#include "analysis/fragments.h"
#include "analysis/series.h"

namespace tidewater::analysis {

// Flat arrays, one entry per particle of ice.
struct IceAtRest {
    std::span<const float> points;        // m, (x, y, z) per particle, before anything moved; y = 0 in 2D
    std::span<const float> volume;        // m³ (2D: m²)
    std::span<const float> failure_time;  // s; NaN: never failed
};

struct CalvingSettings {
    int dimension = 2;             // 2 or 3
    double spacing = 0.0;          // of the particles, m, > 0
    double reach = usual_reach;    // of a connection, in spacings
    double smallest_share = 0.05;  // an iceberg's volume, over the ice's height² × width
};

enum class CrackStart { top, bottom, inside };

// The third of the height in which a share of it lies; inside for NaN.
constexpr CrackStart crack_start(double height_share) {
    if (height_share > 2.0 / 3.0) return CrackStart::top;
    return height_share < 1.0 / 3.0 ? CrackStart::bottom : CrackStart::inside;
}

// Lengths are distances behind the front, m. NaN: no row of that height has both the iceberg and the rear's
// part.
struct Calving {
    double time = none;           // s, of the detachment
    double length = none;         // averaged over the height
    double length_top = none;     // in the uppermost twentieth of the height, or row
    double length_middle = none;  // within a twentieth of mid-height, or a row
    double length_bottom = none;  // in the lowest twentieth
    double height = none;         // of the ice in front of the crack, m
    double volume = none;         // of the iceberg's intact ice, m³ (2D: m²)
    // Where the crack began, from 0 at the base to 1 at the surface: the median height of the earlier half of
    // the rows, by each row's first failure; so a toe or a shelf's edge that was crushed before, over less
    // than a quarter of the height, does not count. And the first failure in that third of the height.
    double start_height = none;
    double start_time = none;  // s
    // The failure plane: that of least squares, by distances at right angles to it, through the cracks of all
    // rows. Its angle to the horizontal, degrees: 90 is upright, less where the crack is farther behind the
    // front at the top than at the base. foot_angle is that of the plane from the front's foot to the crack's
    // place at the top, atan(height/length_top).
    double plane_angle = none;
    double plane_misfit = none;  // m, root mean square of those distances
    double foot_angle = none;

    // The third of the height in which start_height lies; inside if there is none.
    CrackStart start() const { return crack_start(start_height); }
};

// smallest_share as a volume, m³ (2D: m²). The ice must have a particle.
double smallest_iceberg(const IceAtRest& ice, const CalvingSettings& settings);

// The rear is what lies within a tenth of the height, and at least a spacing, of the least x. It holds
// together and counts as intact whatever fails there, for what pushes the ice may crush it. Nothing if no
// part of smallest_share came off.
std::optional<Calving> first_detachment(const IceAtRest& ice, const CalvingSettings& settings);

}  // namespace tidewater::analysis
