// Where the parts of a frame's picture are on its page.
#pragma once

#include <array>

#include "io/picture.h"

namespace tidewater::io {

// Everything about the page is in units of `unit`, one pixel of a page 1600 wide.
struct Layout {
    double unit;
    double letters;      // size of the text
    Pixel low, high;     // corners of the tank's frame (3D: of its silhouette)
    int width, height;   // of the page
    double left, right;  // between which the heading and the legend are
    View view;
};

Layout make_layout(const PictureSettings& settings);

// Of the part of the tank that is shown; the bits 1, 2 and 4 of index choose the high end of x, y and z.
std::array<double, 3> corner(const PictureSettings& settings, int index);

}  // namespace tidewater::io
