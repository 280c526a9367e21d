// An annotated figure as SVG: lines, shapes, text and pictures of pixels, each over what was drawn before.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/provenance.h"
#include "io/canvas.h"

namespace tidewater::io {

enum class Align { left, center, right };

// Width of a line of text of this size in the font of all pictures, pixels.
double text_width(double size, const std::string& text);

class Drawing {
public:
    Drawing(int width, int height) : width_(width), height_(height) {}

    int width() const { return width_; }  // pixels
    int height() const { return height_; }

    void rectangle(Pixel low, Pixel high, Color color, double opacity = 1.0);
    void line(Pixel from, Pixel to, double width, Color color, double opacity = 1.0);
    void dashed_line(Pixel from, Pixel to, double width, double dash, double gap, Color color,
                     double opacity = 1.0);
    void polyline(std::span<const Pixel> points, double width, Color color);
    void polygon(std::span<const Pixel> corners, Color color);
    void triangle(Pixel a, Pixel b, Pixel c, Color color);

    // One line of text, vertically centred on `at`; size is the height of its letters' body in pixels. The
    // rim is a white one of half this width around the letters.
    void text(Pixel at, Align align, double size, const std::string& text, Color color = palette::ink,
              double rim = 0.0);

    // The canvas' pixels, its upper left corner at `corner`.
    void image(const Canvas& canvas, Pixel corner);

    // A box filled with color(share), share from 0 at its left (or lower) side to 1 at the right (upper) one.
    void color_bar(Pixel low, Pixel high, const std::function<Color(double share)>& color, bool upward);

    // The whole SVG file.
    std::string svg(const Provenance& provenance) const;

private:
    int width_, height_;
    std::string body_;
};

}  // namespace tidewater::io
