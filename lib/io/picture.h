// One frame as an annotated picture: water coloured by speed, ice by damage or by iceberg, blocks, the
// still-water level, gauges, axes and a scale bar in m, the time and a legend.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/drawing.h"
#include "io/particle_image.h"

namespace tidewater::io {

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

// 2D: the x-z plane, cut off at `low` and `high`. 3D: a parallel projection from the front, right and above,
// with shading; nothing should be outside of `low` to `high`. The twelve icebergs of most particles have
// their numbers on them. The same particles give the same picture.
Drawing draw_picture(const PictureParticles& particles, const PictureSettings& settings);

}  // namespace tidewater::io
