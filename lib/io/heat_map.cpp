#include "io/heat_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "io/canvas.h"
#include "io/chart_frame.h"
#include "io/chart_lines.h"
#include "io/svg.h"

namespace tidewater::io {
namespace {

constexpr double margin_left = 78, margin_right = 112, margin_bottom = 52, bar_gap = 22, bar_width = 18;

Color cell_color(const HeatMap& map, double greatest, double value) {
    if (!std::isfinite(value)) return palette::no_value;
    return map.scale == HeatScale::diverging ? diverging_color(value / greatest)
                                             : scale_color(value / greatest);
}

double scale_end(const HeatMap& map) {
    if (map.greatest > 0.0) return map.greatest;
    double greatest = 0.0;
    for (const double value : map.values) {
        if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
    }
    return greatest > 0.0 ? round_up(greatest) : 1.0;
}

// Mean of the finite values of a block of cells; none: no number.
double block_mean(const HeatMap& map, std::size_t first_column, std::size_t end_column, std::size_t first_row,
                  std::size_t end_row) {
    double sum = 0.0, count = 0.0;
    for (std::size_t row = first_row; row < end_row; ++row) {
        for (std::size_t column = first_column; column < end_column; ++column) {
            const double value = map.values[row * map.columns + column];
            if (!std::isfinite(value)) continue;
            sum += value;
            count += 1.0;
        }
    }
    return sum / count;
}

// A pixel per cell, or per block of cells where the frame has fewer than half as many pixels.
Canvas cells(const HeatMap& map, double greatest, const ChartFrame& frame) {
    const auto pixels = [](std::size_t count, double length) {
        return std::min(count, static_cast<std::size_t>(2.0 * length));
    };
    const std::size_t width = pixels(map.columns, frame.right - frame.left),
                      height = pixels(map.rows, frame.bottom - frame.top);
    Canvas canvas(static_cast<int>(width), static_cast<int>(height));
    for (std::size_t j = 0; j < height; ++j) {
        for (std::size_t i = 0; i < width; ++i) {
            const double mean = block_mean(map, i * map.columns / width, (i + 1) * map.columns / width,
                                           j * map.rows / height, (j + 1) * map.rows / height);
            canvas.blend(static_cast<int>(i), static_cast<int>(height - 1 - j),
                         cell_color(map, greatest, mean));
        }
    }
    return canvas;
}

std::string draw_color_bar(const HeatMap& map, double greatest, const ChartFrame& frame) {
    constexpr int steps = 256;
    const bool diverging = map.scale == HeatScale::diverging;
    const ChartAxis axis{diverging ? -greatest : 0.0, greatest};
    Canvas canvas(1, steps);
    for (int i = 0; i < steps; ++i) {
        const double value = std::lerp(axis.low, axis.high, (i + 0.5) / steps);
        canvas.blend(0, steps - 1 - i, cell_color(map, greatest, value));
    }
    const double left = frame.right + bar_gap, right = left + bar_width;
    std::string svg = svg_image(left, frame.top, right, frame.bottom, canvas.png());
    svg += svg_rectangle(left, frame.top, right, frame.bottom, svg_stroke(palette::ink, 1.0));
    const Ticks ticks = axis.ticks(std::max(2, static_cast<int>((frame.bottom - frame.top) / 30)));
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y = frame.bottom - (frame.bottom - frame.top) * axis.share(ticks.values[i]);
        svg += svg_line(right, y, right + 4, y, svg_stroke(palette::ink, 1.0));
        svg += svg_text(right + 7, y + 4, "start", ticks.labels[i]);
    }
    return svg + svg_text(left, frame.top - 9, "start", map.value_label);
}

}  // namespace

std::string draw_heat_map(const HeatMap& map, const Provenance& provenance) {
    assert(map.values.size() == map.columns * map.rows && map.left < map.right && map.bottom < map.top);
    std::vector<LegendEntry> entries;
    for (const ChartLine& line : map.lines) entries.push_back(legend_entry(line));
    const bool has_gaps = !std::ranges::all_of(map.values, [](double value) { return std::isfinite(value); });
    if (has_gaps)
        entries.push_back(
            {"no value", svg_rectangle(0, -7, 24, 7, "fill=\"" + hex(palette::no_value) + "\"")});
    const Legend legend = draw_legend(entries, margin_left, map.width - margin_right, 52.0);
    const double top = legend.last_y + 20.0 + (entries.empty() ? 0.0 : 10.0), greatest = scale_end(map);
    const ChartFrame frame{margin_left,           map.width - margin_right, top, top + map.panel_height,
                           {map.left, map.right}, {map.bottom, map.top}};
    std::string svg = svg_text(margin_left, 28, "start", map.title, "font-size=\"16\"") + legend.svg;
    if (!map.values.empty())
        svg += svg_image(frame.left, frame.top, frame.right, frame.bottom, cells(map, greatest, frame).png());
    std::string lines;
    for (const ChartLine& line : map.lines) lines += draw_line(frame, line, true);
    svg += svg_clipped(frame.left, frame.top, frame.right, frame.bottom, lines);
    svg += draw_frame(frame, map.x_label, map.y_label, false);
    svg += draw_color_bar(map, greatest, frame);
    return svg_file(map.width, frame.bottom + margin_bottom, svg, provenance);
}

}  // namespace tidewater::io
