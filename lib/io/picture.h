// One frame as an annotated picture: water coloured by speed, ice by damage, blocks, the still-water level,
// gauges, axes in m.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/canvas.h"

namespace tidewater::io {

// Flat arrays as in Snapshot.
struct PictureParticles {
    std::span<const float> points;           // m, (x, y, z) per particle
    std::span<const float> velocity;         // m/s, (x, y, z) per particle
    std::span<const std::uint8_t> material;  // numbers of core's Material
    std::span<const float> damage = {};      // empty: ice is drawn as intact
};

struct PictureSettings {
    int dimension = 2;
    std::array<double, 3> low{},
        high{};                     // m, corners of the part of the tank that is shown; y not read in 2D
    double particle_spacing = 0.0;  // m, > 0
    double still_level = 0.0;       // z of the still water surface, m
    double greatest_speed = 1.0;    // m/s, the colour scale's upper end, > 0
    double time = 0.0;              // s
    std::string title;
    std::vector<std::array<double, 2>> gauges;  // (x, y), m; y is not read in 2D
    // Corners of the ground, m; x rises, level beyond the ends, for all y; drawn in 2D. Empty: none.
    std::vector<double> ground_x, ground_z;
    int width = 1600;  // pixels, at least 400; the height follows from the part that is shown
};

// Water is coloured by its speed, ice by its damage, rigid blocks by their own colour; both have a dark
// outline. 2D: the x-z
// plane. 3D: a parallel projection from the front, right and above, with shading. The same particles give the
// same picture. In 2D what lies outside of `low` to `high` is cut off; in 3D nothing should.
Canvas draw_picture(const PictureParticles& particles, const PictureSettings& settings);

}  // namespace tidewater::io
