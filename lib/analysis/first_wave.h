// The first wave that runs away from a body: its leading crest, followed through the profiles of the surface
// at successive times.
//
// Each profile is smoothed along x with a Gaussian of standard deviation 0.1 D, at least 2 Δx, as gauges are
// over time (wave.h): a wave as long as the water is deep loses 18 % of its amplitude, 2 D 5 %, 4 D 1.2 %,
// 8 D 0.3 %. Elevations count from the median of the first profile, since the still surface as read may be
// off by a part of a cell.
//
// A crest falls by more than 0.02 Δx on both sides; a hump against the body, which falls on the outer side
// alone, is a crest too: as such most waves begin. The leading crest of a profile is the farthest one that is
// higher than 0.04 Δx and than 0.15 of the highest crest farther than D from the source, so that neither
// noise ahead of the wave nor a splash beside the body decides; crests behind it may be higher. It is found
// at the latest time and followed backward: from one profile to the one before it has moved at most
// 1.6 √(gD) Δt + 0.1 D outward and 0.1 D inward and fallen to no less than a third, and of crests in that
// reach it is the one nearest to where its own recent speed puts it. Two profiles in a row may lack it. Where the leading crest of an earlier
// profile leads to a longer track, that one counts. Position and height come from a parabola through what
// lies within 0.1 of the height below the crest.
//
// The far wall: what follows the first profile in which the water there is higher or lower than 0.2 of the
// leading crest is not looked at. The crest itself then holds a much smaller part of the reflection.
//
// Test: tests/unit/analysis/first_wave_test.cpp, against a solitary wave, dispersing humps (Fourier's
// integral and Airy's limit) and a trough that leads.
#pragma once

#include <span>
#include <vector>

#include "analysis/series.h"

namespace tidewater::analysis {

struct SurfaceProfile {
    double time = 0.0;              // s
    std::vector<double> elevation;  // η at each place, m; NaN where it is dry or a body covers it
};

struct FirstWaveSettings {
    double depth = 0.0;      // D of the still water > 0, m
    double gravity = 9.81;   // g > 0, m/s²
    double cell_size = 0.0;  // Δx > 0, m, of the grid with which the surface was read
    double source = 0.0;     // x from which distances count, m
    double wall = 0.0;  // x of the wall that the wave runs towards, m: to the right or left of the source
};

struct CrestPoint {
    double time = none;       // s
    double x = none;          // m
    double distance = none;   // from the source, m
    double amplitude = none;  // η, m
};

struct FirstWave {
    std::vector<CrestPoint> track;  // by time; empty: no wave was found
    CrestPoint greatest;            // where it was highest, between profiles by a parabola over time

    // Least squares of distance over time, m/s, from `formed` (s) on: when the crest has passed its greatest
    // height and 2 D, where the laboratory's first gauges stood. NaN with less than D behind that.
    double celerity = none;
    double formed = none;
};

// x: of the places, m, rising; between the source and the wall a place per cell or so. profiles: by time,
// each with an elevation per place. What lies between the source and the outermost place without an
// elevation is not looked at.
FirstWave follow_first_wave(std::span<const double> x, std::span<const SurfaceProfile> profiles,
                            const FirstWaveSettings& settings);

// How far the leading crest of a linear wave has run that a short disturbance made at t = 0, m: Airy's wave
// front, √(gD) t − 1.0188 (√(gD) D² t/2)^(1/3). Dispersion makes it slower than √(gD): by 10 % at 1.5 s in
// water 1 m deep, by 4 % at 5 s.
double linear_crest_distance(double depth, double gravity, double time);

// The track's amplitude where it passes a distance from the source for the last time, linearly between
// points, m; NaN if it does not.
double amplitude_at(const FirstWave& wave, double distance);

}  // namespace tidewater::analysis
