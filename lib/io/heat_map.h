// A quantity over two axes as SVG: coloured cells with a colour bar, axes and lines over them, as a
// space-time diagram η(x, t).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "io/chart.h"

namespace tidewater::io {

enum class HeatScale {
    diverging,   // diverging_color from -greatest to greatest
    sequential,  // scale_color from 0 to greatest
};

struct HeatMap {
    std::string title;
    std::string x_label, y_label, value_label;  // with units: "x (m)", "time (s)", "η (m)"
    double left = 0.0, right = 1.0;             // x at the outer edges of the first and the last column
    double bottom = 0.0, top = 1.0;             // y at those of the first and the last row
    std::size_t columns = 0, rows = 0;          // of cells, all alike
    std::vector<double> values = {};            // columns × rows, row by row, the first at `bottom`; what is
                                                // not finite is grey
    HeatScale scale = HeatScale::diverging;
    double greatest = 0.0;                       // the scale's end, > 0; 0: from the values, rounded up
    std::vector<ChartLine> lines = {};           // over the cells, with a white rim; cut off at the frame
    double width = 960.0, panel_height = 420.0;  // pixels, of the page and of the frame
};

// The whole SVG file, with the cells as a picture in it and the provenance as its metadata. Where more than
// two cells fall on a pixel, their mean is shown.
std::string draw_heat_map(const HeatMap& map, const Provenance& provenance);

}  // namespace tidewater::io
