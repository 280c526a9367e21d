#include "io/chart.h"

#include <algorithm>
#include <cmath>

#include "io/chart_lines.h"
#include "io/svg.h"

namespace tidewater::io {
namespace {

constexpr double margin_left = 78, margin_right = 24, margin_bottom = 52, gap = 14,
                 own_axis_share = 0.04,  // of an axis' length, left free at both of its ends
    free_above = 0.12;                   // the same of a vertical one

bool has_own_axis(const ChartPanel& panel) { return !panel.x_label.empty(); }

bool has_place(double value, bool logarithmic) { return !logarithmic || value > 0.0; }

void include_x(const ChartPanel& panel, bool logarithmic, Range& range) {
    for (const ChartLine& line : panel.lines) {
        for (const double x : line.x) {
            if (has_place(x, logarithmic)) range.include(x);
        }
    }
}

bool shared_log_x(const Chart& chart) {
    const auto first = std::ranges::find_if_not(chart.panels, has_own_axis);
    return first != chart.panels.end() && first->log_x;
}

// Of the panels that share it.
ChartAxis shared_axis(const Chart& chart) {
    Range range;
    for (const ChartPanel& panel : chart.panels) {
        if (!has_own_axis(panel)) include_x(panel, shared_log_x(chart), range);
    }
    return axis_around(range, 0.0, shared_log_x(chart));
}

void include_y(const ChartPanel& panel, Range& range) {
    const auto include = [&](double y) {
        if (has_place(y, panel.log_y)) range.include(y);
    };
    for (const ChartLine& line : panel.lines) std::ranges::for_each(line.y, include);
    for (const ChartMark& mark : panel.marks) {
        if (reads_y(mark.shape)) include(mark.y);
    }
}

std::vector<LegendEntry> legend_entries(const Chart& chart) {
    std::vector<LegendEntry> entries;
    for (const ChartPanel& panel : chart.panels) {
        for (const ChartLine& line : panel.lines) entries.push_back(legend_entry(line));
        for (const ChartMark& mark : panel.marks) entries.push_back(legend_entry(mark));
    }
    return entries;
}

std::string draw_panel(const ChartFrame& frame, const ChartPanel& panel, const std::string& x_label) {
    std::string svg = draw_frame(frame, x_label, panel.y_label);
    for (const ChartLine& line : panel.lines) svg += draw_line(frame, line);
    for (const ChartMark& mark : panel.marks) svg += draw_mark(frame, mark);
    if (!panel.title.empty()) {
        svg += svg_text(frame.left + 9, frame.top + 17, "start", panel.title,
                        "font-weight=\"bold\" paint-order=\"stroke\" stroke=\"white\" stroke-width=\"4\"");
    }
    return svg;
}

// What stands below each panel: its own label, the chart's below the last that shares it, or nothing.
std::vector<std::string> x_labels(const Chart& chart) {
    std::vector<std::string> labels(chart.panels.size());
    bool shared = true;
    for (std::size_t i = chart.panels.size(); i-- > 0;) {
        const ChartPanel& panel = chart.panels[i];
        labels[i] = has_own_axis(panel) ? panel.x_label : (shared ? chart.x_label : "");
        shared = shared && has_own_axis(panel);
    }
    return labels;
}

// Frames below each other; x and y from the lines and marks.
std::vector<ChartFrame> make_frames(const Chart& chart, const std::vector<std::string>& labels,
                                    double first_top) {
    const ChartAxis shared = shared_axis(chart);
    Range all;
    for (const ChartPanel& panel : chart.panels) include_y(panel, all);
    std::vector<ChartFrame> frames;
    double top = first_top;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const ChartPanel& panel = chart.panels[i];
        Range x, y;
        include_x(panel, panel.log_x, x);
        include_y(panel, y);
        const double height = panel.height > 0.0 ? panel.height : chart.panel_height;
        frames.push_back({margin_left, chart.width - margin_right, top, top + height,
                          has_own_axis(panel) ? axis_around(x, own_axis_share, panel.log_x) : shared,
                          axis_around(chart.one_y_range ? all : y, free_above, panel.log_y)});
        top += height + gap + (labels[i].empty() ? 0.0 : margin_bottom);
    }
    return frames;
}

}  // namespace

std::string draw_chart(const Chart& chart, const Provenance& provenance) {
    const std::vector<std::string> labels = x_labels(chart);
    const Legend legend = draw_legend(legend_entries(chart), margin_left, chart.width, 52.0);
    const double first_top = legend.last_y + 20.0;
    const std::vector<ChartFrame> frames = make_frames(chart, labels, first_top);
    const double height = (frames.empty() ? first_top : frames.back().bottom) + margin_bottom;

    std::string svg = svg_text(margin_left, 28, "start", chart.title, "font-size=\"16\"");
    svg += legend.svg;
    for (std::size_t i = 0; i < frames.size(); ++i) svg += draw_panel(frames[i], chart.panels[i], labels[i]);
    return svg_file(chart.width, height, svg, provenance);
}

}  // namespace tidewater::io
