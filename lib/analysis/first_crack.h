// The first crack: when there was one, and where it began, whether or not anything came off.
//
// Everything is measured in the ice at rest, as calving.h does. A crack is a band of particles that failed
// and hang together as fragments.h says. The particles are added in the order of increasing failure time; the
// first band whose extent in height reaches `extent` is the first crack, and the particles that it has then
// tell where it began. What joins it later does not matter.
//
// Two things fail that are no cracks. Where the ice stands on the edge of a shelf and where its toe meets the
// water it is crushed in a layer along the base: what fails within `layer` above the base is left out, and so
// a crack that runs up from that layer counts from the layer's top on, and one that comes down to it is not
// joined by what the layer holds. And bands that hang together with what failed at the rear (box.h) are the
// work of what pushes the ice.
// Test: tests/unit/analysis/first_crack_test.cpp
#pragma once

#include <optional>

#include "analysis/calving.h"

namespace tidewater::analysis {

struct FirstCrackSettings {
    double spacing = 0.0;        // of the particles, m, > 0
    double reach = usual_reach;  // of a connection, in spacings
    double extent = 0.25;        // of a crack, over the ice's height
    double layer = 0.15;         // along the base, likewise
};

// Where it began is told in two steps. The third of the height (CrackStart) is that of the median height of
// the earlier half of the rows, by each row's first failure in the band, as in calving.h: so a few particles
// that failed before and that the crack ran into do not count. The start itself is the band's first failure
// in that third; of several in one step the mean.
struct FirstCrack {
    double time = 0.0;          // s, at which it had the extent
    double start_time = 0.0;    // s
    double start_height = 0.0;  // from 0 at the base to 1 at the surface, both where it began
    double position = 0.0;      // m, behind the ice's own front at that height

    CrackStart start() const { return crack_start(start_height); }
};

// Nothing if no band had the extent. NaN in failure_time: never failed.
std::optional<FirstCrack> first_crack(const IceAtRest& ice, const FirstCrackSettings& settings);

}  // namespace tidewater::analysis
