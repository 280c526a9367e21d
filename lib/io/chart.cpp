#include "io/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/axis.h"
#include "io/color.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr double margin_left = 78, margin_right = 24, margin_top = 72, margin_bottom = 52, gap = 14,
                 legend_line = 20,  // between the lines of the legend
    own_axis_share = 0.04;          // of an axis' length, left free at both of its ends

constexpr Color faint_line{150, 155, 162};

std::string number(double value) { return format_fixed(value, 2); }

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void include(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }

    // With a share of its length added on both sides; of length 1 if it holds one value, from 0 to 1 if none.
    Range padded(double share) const {
        if (low > high) return {0.0, 1.0};
        if (low == high) return {low - 0.5, high + 0.5};
        return {low - share * (high - low), high + share * (high - low)};
    }
};

// Where on its axis a value is; of no place on a logarithmic one: not finite.
double scaled(double value, bool log) { return log ? std::log10(value) : value; }

// A panel's frame on the page and the scaled values at its edges.
struct Frame {
    double left, right, top, bottom;
    Range x, y;
    bool log_x = false, log_y = false;

    // Shares of the axes' lengths.
    double along(double value) const { return (scaled(value, log_x) - x.low) / (x.high - x.low); }
    double upward(double value) const { return (scaled(value, log_y) - y.low) / (y.high - y.low); }
    double at_x(double value) const { return left + (right - left) * along(value); }
    double at_y(double value) const { return bottom - (bottom - top) * upward(value); }
    bool holds_x(double value) const { return along(value) >= 0.0 && along(value) <= 1.0; }
};

Ticks ticks_of(const Range& range, bool log, int greatest_count) {
    return (log ? make_log_ticks : make_ticks)(range.low, range.high, greatest_count);
}

std::string svg_line(double x1, double y1, double x2, double y2, const std::string& style) {
    return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" +
           number(y2) + "\" " + style + "/>\n";
}

std::string svg_text(double x, double y, const std::string& anchor, const std::string& text,
                     const std::string& style = {}) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" " + style +
           ">" + escape_xml(text) + "</text>\n";
}

std::string svg_dot(double x, double y, std::size_t color) {
    return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"4\" fill=\"" +
           hex(line_color(color)) + "\" stroke=\"white\"/>\n";
}

// Twelve wide, its middle at (x, y); up: 1, down: -1.
std::string svg_triangle(double x, double y, double up, const std::string& style) {
    return "<polygon points=\"" + number(x - 6) + "," + number(y + 5 * up) + " " + number(x + 6) + "," +
           number(y + 5 * up) + " " + number(x) + "," + number(y - 6 * up) + "\" " + style + "/>\n";
}

std::string stroke(Color color, double width, const char* dashes = nullptr) {
    std::string style = "fill=\"none\" stroke=\"" + hex(color) + "\" stroke-width=\"" + number(width) + "\"";
    if (dashes) style += std::string(" stroke-dasharray=\"") + dashes + "\"";
    return style;
}

std::string line_style(const ChartLine& line) {
    const char* dashes = line.dashed ? "7 4" : nullptr;
    return line.faint ? stroke(faint_line, 1.0, dashes) : stroke(line_color(line.color), 1.6, dashes);
}

std::string rule_style(const ChartMark& mark) { return stroke(line_color(mark.color), 1.2, "3 3"); }

bool reads_y(MarkShape shape) { return shape != MarkShape::rule && shape != MarkShape::beyond; }

std::string svg_ring(double x, double y, Color color) {
    return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"4\" " + stroke(color, 1.6) + "/>\n";
}

// Any shape but a rule.
std::string mark_symbol(const ChartMark& mark, double x, double y) {
    const std::string color = hex(line_color(mark.color));
    const std::string filled = "fill=\"" + color + "\" stroke=\"white\"";
    if (mark.shape == MarkShape::point_down) return svg_triangle(x, y, -1.0, filled);
    if (mark.shape == MarkShape::point_up) return svg_triangle(x, y, 1.0, filled);
    if (mark.shape == MarkShape::ring) return svg_ring(x, y, line_color(mark.color));
    if (mark.shape == MarkShape::beyond)
        return svg_triangle(x, y, 1.0, "fill=\"white\" stroke-width=\"1.6\" stroke=\"" + color + "\"");
    return svg_dot(x, y, mark.color);
}

bool has_own_axis(const ChartPanel& panel) { return !panel.x_label.empty(); }

void include_x(const ChartPanel& panel, bool log, Range& range) {
    for (const ChartLine& line : panel.lines) {
        for (const double x : line.x) range.include(scaled(x, log));
    }
}

bool shared_log_x(const Chart& chart) {
    const auto first = std::ranges::find_if_not(chart.panels, has_own_axis);
    return first != chart.panels.end() && first->log_x;
}

// Of the panels that share it.
Range x_range(const Chart& chart) {
    Range range;
    for (const ChartPanel& panel : chart.panels) {
        if (!has_own_axis(panel)) include_x(panel, shared_log_x(chart), range);
    }
    return range.padded(0.0);
}

void include_y(const ChartPanel& panel, Range& range) {
    for (const ChartLine& line : panel.lines) {
        for (const double y : line.y) range.include(scaled(y, panel.log_y));
    }
    for (const ChartMark& mark : panel.marks) {
        if (reads_y(mark.shape)) range.include(scaled(mark.y, panel.log_y));
    }
}

// x_label: empty where the axis is labelled below another panel.
std::string draw_axes(const Frame& frame, const ChartPanel& panel, const std::string& x_label) {
    const std::string grid = "stroke=\"" + hex(palette::faint) + "\" stroke-width=\"0.7\"";
    std::string svg;
    const Ticks along = ticks_of(frame.x, frame.log_x, 12);
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const double x = frame.at_x(along.values[i]);
        svg += svg_line(x, frame.top, x, frame.bottom, grid);
        if (!x_label.empty()) svg += svg_text(x, frame.bottom + 17, "middle", along.labels[i]);
    }
    const int count = std::max(2, static_cast<int>((frame.bottom - frame.top) / 30));
    const Ticks upward = ticks_of(frame.y, frame.log_y, count);
    for (std::size_t i = 0; i < upward.values.size(); ++i) {
        const double y = frame.at_y(upward.values[i]);
        svg += svg_line(frame.left, y, frame.right, y, grid);
        svg += svg_text(frame.left - 7, y + 4, "end", upward.labels[i]);
    }
    svg += "<rect x=\"" + number(frame.left) + "\" y=\"" + number(frame.top) + "\" width=\"" +
           number(frame.right - frame.left) + "\" height=\"" + number(frame.bottom - frame.top) +
           "\" fill=\"none\" stroke=\"" + hex(palette::ink) + "\"/>\n";
    svg += svg_text(0.5 * (frame.left + frame.right), frame.bottom + 40, "middle", x_label);
    const std::string place = number(frame.left - 58) + " " + number(0.5 * (frame.top + frame.bottom));
    svg += svg_text(0, 0, "middle", panel.y_label, "transform=\"translate(" + place + ") rotate(-90)\"");
    return svg;
}

std::string draw_line(const Frame& frame, const ChartLine& line) {
    std::string path, dots;
    bool pen_down = false;
    for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
        const double x = frame.at_x(line.x[i]), y = frame.at_y(line.y[i]);
        if (!std::isfinite(x) || !std::isfinite(y)) {
            pen_down = false;
            continue;
        }
        path += (pen_down ? "L" : "M") + number(x) + " " + number(y);
        pen_down = true;
        if (line.dots) dots += svg_dot(x, y, line.color);
    }
    return path.empty() ? path : "<path d=\"" + path + "\" " + line_style(line) + "/>\n" + dots;
}

std::string draw_mark(const Frame& frame, const ChartMark& mark) {
    if (!frame.holds_x(mark.x)) return {};
    const double x = frame.at_x(mark.x);
    if (mark.shape == MarkShape::rule) {
        return svg_line(x, frame.top, x, frame.bottom, rule_style(mark)) +
               svg_text(x - 5, frame.bottom - 6, "end", mark.note);
    }
    const double y = reads_y(mark.shape) ? frame.at_y(mark.y) : frame.top + 9;
    if (!std::isfinite(y)) return {};
    return mark_symbol(mark, x, y) + svg_text(x + 8, y - 3, "start", mark.note);
}

struct Legend {
    std::string svg;
    double added_height = 0.0;  // by lines after the first
};

Legend draw_legend(const Chart& chart, double first_y) {
    std::string svg;
    std::vector<std::string> named;
    double x = margin_left, y = first_y;
    const auto entry = [&](const std::string& label, const std::string& symbol) {
        if (label.empty() || std::ranges::find(named, label) != named.end()) return;
        named.push_back(label);
        const double width = 54.0 + 7.0 * static_cast<double>(label.size());
        if (x > margin_left && x + width > chart.width) {
            x = margin_left;
            y += legend_line;
        }
        svg += "<g transform=\"translate(" + number(x) + " " + number(y) + ")\">" + symbol + "</g>\n";
        svg += svg_text(x + 30, y + 4, "start", label);
        x += width;
    };
    for (const ChartPanel& panel : chart.panels) {
        for (const ChartLine& line : panel.lines) {
            entry(line.label,
                  svg_line(0, 0, 24, 0, line_style(line)) + (line.dots ? svg_dot(12, 0, line.color) : ""));
        }
        for (const ChartMark& mark : panel.marks) {
            const bool rule = mark.shape == MarkShape::rule;
            entry(mark.label, rule ? svg_line(12, -8, 12, 8, rule_style(mark)) : mark_symbol(mark, 12, 0));
        }
    }
    return {svg, y - first_y};
}

std::string metadata(const Provenance& provenance) {
    std::string svg = "<metadata>\n";
    for (const auto& [name, text] : provenance_fields(provenance))
        svg += name + ": " + escape_xml(text) + "\n";
    return svg + "</metadata>\n";
}

std::string draw_panel(const Frame& frame, const ChartPanel& panel, const std::string& x_label) {
    std::string svg = draw_axes(frame, panel, x_label);
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
std::vector<Frame> make_frames(const Chart& chart, const std::vector<std::string>& labels, double first_top) {
    const Range shared = x_range(chart);
    Range all;
    for (const ChartPanel& panel : chart.panels) include_y(panel, all);
    std::vector<Frame> frames;
    double top = first_top;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const ChartPanel& panel = chart.panels[i];
        Range x, y;
        const bool log_x = has_own_axis(panel) ? panel.log_x : shared_log_x(chart);
        include_x(panel, log_x, x);
        include_y(panel, y);
        const double height = panel.height > 0.0 ? panel.height : chart.panel_height;
        frames.push_back({margin_left, chart.width - margin_right, top, top + height,
                          has_own_axis(panel) ? x.padded(own_axis_share) : shared,
                          (chart.one_y_range ? all : y).padded(0.12), log_x, panel.log_y});
        top += height + gap + (labels[i].empty() ? 0.0 : margin_bottom);
    }
    return frames;
}

}  // namespace

std::string draw_chart(const Chart& chart, const Provenance& provenance) {
    const std::vector<std::string> labels = x_labels(chart);
    const Legend legend = draw_legend(chart, 52);
    const double first_top = margin_top + legend.added_height;
    const std::vector<Frame> frames = make_frames(chart, labels, first_top);
    const double height = (frames.empty() ? first_top : frames.back().bottom) + margin_bottom;

    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(chart.width) +
                      "\" height=\"" + number(height) + "\" viewBox=\"0 0 " + number(chart.width) + " " +
                      number(height) +
                      "\" font-family=\"DejaVu Sans, Arial, sans-serif\" font-size=\"12\" fill=\"" +
                      hex(palette::ink) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    svg += metadata(provenance);
    svg += svg_text(margin_left, 28, "start", chart.title, "font-size=\"16\"");
    svg += legend.svg;
    for (std::size_t i = 0; i < frames.size(); ++i) svg += draw_panel(frames[i], chart.panels[i], labels[i]);
    return svg + "</svg>\n";
}

}  // namespace tidewater::io
