// What is drawn in a chart's frame, lines and marks, and the legend that names them; as SVG elements.
#pragma once

#include <string>
#include <vector>

#include "io/chart.h"
#include "io/chart_frame.h"

namespace tidewater::io {

// rim: white on both sides, to be told from what lies below.
std::string draw_line(const ChartFrame& frame, const ChartLine& line, bool rim = false);
std::string draw_mark(const ChartFrame& frame, const ChartMark& mark);

// Whether a mark's y is a value.
bool reads_y(MarkShape shape);

struct LegendEntry {
    std::string label;   // empty: not shown
    std::string symbol;  // 24 wide, from (0, 0) to the right
};

LegendEntry legend_entry(const ChartLine& line);
LegendEntry legend_entry(const ChartMark& mark);

struct Legend {
    std::string svg;
    double last_y;  // the middle of its last row
};

// Each label once, in rows from `left` to at most `right`, the first with its middle at first_y.
Legend draw_legend(const std::vector<LegendEntry>& entries, double left, double right, double first_y);

}  // namespace tidewater::io
