// A part of a page with two axes in m: where a place lies on it, and its frame with ticks.
#pragma once

#include <string>

#include "io/drawing.h"

namespace tidewater::io {

struct Panel {
    Pixel low, high;                           // upper left and lower right corner on the page
    double left = 0.0, right = 1.0;            // m, at the sides
    double bottom = 0.0, top = 1.0;            // m
    std::string across_label, upward_label{};  // "x (m)", "z (m)"

    Pixel at(double across, double upward) const;
    double across(double pixel_x) const;  // of a place on the page
    double upward(double pixel_y) const;
};

// Frame, ticks, their numbers and the labels; `unit` as in pictures, one pixel of a page 1600 wide. The
// numbers and the label below take 60 units, those to the left 84.
void draw_axes(Drawing& drawing, const Panel& panel, double unit);

}  // namespace tidewater::io
