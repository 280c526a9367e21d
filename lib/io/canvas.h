// A picture in memory and the PNG file made from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/provenance.h"
#include "io/color.h"

namespace tidewater::io {

struct Pixel {
    double
        x = 0.0,
        y = 0.0;  // from the upper left corner to the right and down; a pixel's centre is at (i + ½, j + ½)
};

class Canvas {
public:
    // opacity of the background, in [0, 1].
    Canvas(int width, int height, Color background = palette::paper, double opacity = 1.0);

    int width() const { return width_; }
    int height() const { return height_; }
    Color at(int x, int y) const { return pixels_[index(x, y)]; }

    // Lays the colour over one pixel; opacity in [0, 1]. Outside nothing happens.
    void blend(int x, int y, Color color, double opacity = 1.0);

    // The bytes of a PNG file with these text entries, (name, text); with opacities if a pixel is not opaque.
    std::string png(const std::vector<std::pair<std::string, std::string>>& entries = {}) const;

    // Replaces path as a whole; the provenance goes into the text entries. Throws OutputError.
    void write_png(const std::filesystem::path& path, const Provenance& provenance) const;

private:
    std::size_t index(int x, int y) const;

    int width_, height_;
    std::vector<Color> pixels_;
    std::vector<std::uint8_t> opacity_;  // 255: opaque
};

}  // namespace tidewater::io
