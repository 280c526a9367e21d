// What a scene looks like before it moves: a vertical section along x, and, in 3D, the plan seen from above.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "io/drawing.h"
#include "io/panel.h"
#include "io/plan.h"

namespace tidewater::io {

// A vertical dimension line in the section, as of the cliff above the water: at x, from z = low to z = high.
struct Measure {
    double x = 0.0, low = 0.0, high = 0.0;  // m
    std::string text;                       // "cliff 62 m"; to the right of the line
};

struct SectionSettings {
    int dimension = 2;
    std::array<double, 3> low{}, high{};  // m, corners of what is shown; y not read in 2D
    double across = 0.0;                  // m, y of the section
    double still_level =
        std::numeric_limits<double>::quiet_NaN();  // z of the still water, m; no number: none
    std::string title;
    std::vector<Measure> measures;
    std::vector<std::array<double, 2>> gauges;  // (x, y), m; y is not read in 2D

    // What is at a place. It is asked for 3 × 3 samples of each pixel, so cracks show that no level set
    // holds.
    std::function<Substance(double x, double y, double z)> at;
    // For the plan, one sample a pixel; read in 3D; empty: no plan. Both are called in parallel.
    std::function<Top(double x, double y)> top = {};
    int width = 1600;  // pixels, at most; a plan that is nearly square makes the page narrower
};

struct SectionPicture {
    Drawing drawing;
    Panel section, plan;        // where places lie on it
    double exaggeration = 1.0;  // of heights in the section; the picture says so where it is not 1
};

// Section: ground, water, ice and blocks in colours that differ in lightness too, dark outlines of what is
// solid, the still level dashed, dimension lines, in 2D the gauges. The heights of a long thin scene are
// exaggerated by a round number, so that they take at least 260 of the page's 1600 units. Plan: as io/plan.h
// says, to the same scale along x, with the section's line and the gauges. The same functions give the same
// picture. Test: tests/unit/io/section_picture_test.cpp.
SectionPicture draw_section(const SectionSettings& settings);

}  // namespace tidewater::io
