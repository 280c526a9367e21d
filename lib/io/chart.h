// Line charts as SVG: panels below each other over one horizontal axis, or one of their own, with ticks,
// grid, units and a legend.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

struct ChartLine {
    std::string label;         // in the legend; lines of one label share their entry, empty: none
    std::vector<double> x, y;  // of one length; a y that is not finite leaves a gap
    std::size_t color = 0;     // index of line_color
    bool dashed = false;
    bool dots = false;   // at the points
    bool faint = false;  // thin and grey, for what the others are compared with; color is not read
};

enum class MarkShape {
    dot,         // a filled circle
    ring,        // a hollow one
    point_down,  // a filled triangle, as if something came from above
    point_up,    // and from below
    rule,        // a vertical line through the panel; y is not read
    beyond,      // a hollow triangle that points out of the panel's top; y is not read
};

// Not drawn if x, or a y that is read, is not finite.
struct ChartMark {
    std::string label;  // as for ChartLine
    MarkShape shape = MarkShape::dot;
    double x = 0.0, y = 0.0;
    std::size_t color = 1;
    std::string note;  // beside the mark
};

struct ChartPanel {
    std::string title;    // within the panel, upper left
    std::string y_label;  // with its unit: "η (m)"
    std::vector<ChartLine> lines;
    std::vector<ChartMark> marks;
    std::string x_label = {};  // this panel has a horizontal axis of its own; empty: it shares the chart's
    double height = 0.0;       // pixels; 0: the chart's panel_height
    // Logarithmic axes: what is not above 0 has no place, as if it were not finite. Of panels that share the
    // horizontal axis the first one's log_x counts.
    bool log_x = false, log_y = false;
};

struct Chart {
    std::string title;
    std::string x_label;  // with its unit: "time (s)"; of the panels without their own
    std::vector<ChartPanel> panels;
    double width = 960.0;         // pixels
    double panel_height = 120.0;  // pixels
    bool one_y_range = false;     // all panels have the range of y that holds them all
};

// The whole SVG file, with the provenance as its metadata. Texts may be any UTF-8. A chart without points has
// axes from 0 to 1.
std::string draw_chart(const Chart& chart, const Provenance& provenance);

}  // namespace tidewater::io
