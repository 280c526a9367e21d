// SVG pictures as pixels (librsvg), without a display.
#pragma once

#include <filesystem>
#include <string>

#include "core/provenance.h"
#include "io/canvas.h"

namespace tidewater::io {

// The whole picture, `scale` > 0 pixels of the canvas for each of the SVG's, on white. Letters come from the
// fonts of the system, of which fonts-dejavu-core is asked for first. The same text gives the same pixels on
// one machine. Throws OutputError if the text is no SVG or the picture is too large for the memory.
Canvas rasterise(const std::string& svg, double scale = 1.0);

// Writes <path> and, beside it, the same picture as .png at this scale. path ends with ".svg". Throws
// OutputError.
void write_svg_and_png(const std::filesystem::path& path, const std::string& svg, double scale,
                       const Provenance& provenance);

// Of charts: sharp on a page and a screen.
inline constexpr double chart_scale = 2.0;

}  // namespace tidewater::io
