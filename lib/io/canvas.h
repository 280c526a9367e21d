// A picture in memory with what it takes to draw an annotated figure, and the PNG file made from it. Needs no
// display.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "io/color.h"

namespace tidewater::io {

struct Pixel {
    double
        x = 0.0,
        y = 0.0;  // from the upper left corner to the right and down; a pixel's centre is at (i + ½, j + ½)
};

enum class Align { left, center, right };

// Width of a line of text of this size, pixels.
double text_width(double size, const std::string& text);

// What is drawn lies over what was; parts outside are cut off.
class Canvas {
public:
    Canvas(int width, int height, Color background = palette::paper);

    int width() const { return width_; }
    int height() const { return height_; }
    Color at(int x, int y) const { return pixels_[index(x, y)]; }

    // Mixes the colour into one pixel; opacity in [0, 1].
    void blend(int x, int y, Color color, double opacity = 1.0);

    // Edges between pixels are smoothed.
    void rectangle(Pixel low, Pixel high, Color color, double opacity = 1.0);
    void line(Pixel from, Pixel to, double width, Color color, double opacity = 1.0);
    void dashed_line(Pixel from, Pixel to, double width, double dash, double gap, Color color,
                     double opacity = 1.0);
    void triangle(Pixel a, Pixel b, Pixel c, Color color);

    // One line of text, vertically centred on `at`; size is the height of its letters' body in pixels.
    void text(Pixel at, Align align, double size, const std::string& text, Color color = palette::ink);

    // The bytes of a PNG file of it.
    std::string png(const Provenance& provenance) const;

    // Replaces path as a whole; the provenance goes into the PNG's text entries. Throws OutputError.
    void write_png(const std::filesystem::path& path, const Provenance& provenance) const;

private:
    std::size_t index(int x, int y) const;

    // Mixes the colour into the pixels of a box by the share of each that `inside` says, from 4 × 4 samples.
    template <class Inside>
    void fill(Pixel low, Pixel high, const Inside& inside, Color color, double opacity);

    int width_, height_;
    std::vector<Color> pixels_;
};

}  // namespace tidewater::io
