#include "io/chart_lines.h"

#include <algorithm>
#include <cmath>

#include "io/svg.h"

namespace tidewater::io {
namespace {

constexpr double legend_row = 20.0;

constexpr Color faint_line{150, 155, 162};

std::string svg_dot(double x, double y, std::size_t color) {
    return "<circle cx=\"" + svg_number(x) + "\" cy=\"" + svg_number(y) + "\" r=\"4\" fill=\"" +
           hex(line_color(color)) + "\" stroke=\"white\"/>\n";
}

// Twelve wide, its middle at (x, y); up: 1, down: -1.
std::string svg_triangle(double x, double y, double up, const std::string& style) {
    return "<polygon points=\"" + svg_number(x - 6) + "," + svg_number(y + 5 * up) + " " + svg_number(x + 6) +
           "," + svg_number(y + 5 * up) + " " + svg_number(x) + "," + svg_number(y - 6 * up) + "\" " + style +
           "/>\n";
}

std::string line_style(const ChartLine& line) {
    const char* dashes = line.dashed ? "7 4" : nullptr;
    return line.faint ? svg_stroke(faint_line, 1.0, dashes) : svg_stroke(line_color(line.color), 1.6, dashes);
}

std::string rule_style(const ChartMark& mark) { return svg_stroke(line_color(mark.color), 1.2, "3 3"); }

std::string svg_ring(double x, double y, Color color) {
    return "<circle cx=\"" + svg_number(x) + "\" cy=\"" + svg_number(y) + "\" r=\"4\" " +
           svg_stroke(color, 1.6) + "/>\n";
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

double letter_count(const std::string& text) {  // of UTF-8
    return static_cast<double>(std::ranges::count_if(
        text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

}  // namespace

bool reads_y(MarkShape shape) { return shape != MarkShape::rule && shape != MarkShape::beyond; }

std::string draw_line(const ChartFrame& frame, const ChartLine& line, bool rim) {
    std::string path, dots;
    bool pen_down = false;
    for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
        const double x = frame.at_x(line.x[i]), y = frame.at_y(line.y[i]);
        if (!std::isfinite(x) || !std::isfinite(y)) {
            pen_down = false;
            continue;
        }
        path += (pen_down ? "L" : "M") + svg_number(x) + " " + svg_number(y);
        pen_down = true;
        if (line.dots) dots += svg_dot(x, y, line.color);
    }
    if (path.empty()) return {};
    const auto stroked = [&](const std::string& style) {
        return "<path d=\"" + path + "\" " + style + "/>\n";
    };
    return (rim ? stroked(svg_stroke(palette::paper, 4.5)) : "") + stroked(line_style(line)) + dots;
}

std::string draw_mark(const ChartFrame& frame, const ChartMark& mark) {
    const double x = frame.at_x(mark.x);
    if (!std::isfinite(x) || mark.x < frame.x.low || mark.x > frame.x.high) return {};
    if (mark.shape == MarkShape::rule) {
        return svg_line(x, frame.top, x, frame.bottom, rule_style(mark)) +
               svg_text(x - 5, frame.bottom - 6, "end", mark.note);
    }
    const double y = reads_y(mark.shape) ? frame.at_y(mark.y) : frame.top + 9;
    if (!std::isfinite(y)) return {};
    return mark_symbol(mark, x, y) + svg_text(x + 8, y - 3, "start", mark.note);
}

LegendEntry legend_entry(const ChartLine& line) {
    return {line.label,
            svg_line(0, 0, 24, 0, line_style(line)) + (line.dots ? svg_dot(12, 0, line.color) : "")};
}

LegendEntry legend_entry(const ChartMark& mark) {
    const bool rule = mark.shape == MarkShape::rule;
    return {mark.label, rule ? svg_line(12, -8, 12, 8, rule_style(mark)) : mark_symbol(mark, 12, 0)};
}

Legend draw_legend(const std::vector<LegendEntry>& entries, double left, double right, double first_y) {
    std::string svg;
    std::vector<std::string> named;
    double x = left, y = first_y;
    for (const auto& [label, symbol] : entries) {
        if (label.empty() || std::ranges::find(named, label) != named.end()) continue;
        named.push_back(label);
        const double width = 54.0 + 7.0 * letter_count(label);
        if (x > left && x + width > right) {
            x = left;
            y += legend_row;
        }
        svg += "<g transform=\"translate(" + svg_number(x) + " " + svg_number(y) + ")\">" + symbol + "</g>\n";
        svg += svg_text(x + 30, y + 4, "start", label);
        x += width;
    }
    return {svg, y};
}

}  // namespace tidewater::io
