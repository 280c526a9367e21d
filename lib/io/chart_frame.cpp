#include "io/chart_frame.h"

#include <algorithm>
#include <cmath>

#include "io/svg.h"

namespace tidewater::io {

void Range::include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
}

double ChartAxis::share(double value) const {
    if (!logarithmic) return (value - low) / (high - low);
    return value > 0.0 ? std::log(value / low) / std::log(high / low)
                       : std::numeric_limits<double>::quiet_NaN();
}

Ticks ChartAxis::ticks(int greatest_count) const {
    const bool few_decades = !logarithmic || std::log10(high / low) < 1.0 / 3.0;
    return few_decades ? make_ticks(low, high, greatest_count)
                       : make_log_ticks(std::log10(low), std::log10(high), greatest_count);
}

namespace {

// Whether all values are the same but for rounding, which needs no axis of its own.
bool holds_one_value(const Range& range) {
    return range.high - range.low <= 1e-9 * std::max(std::abs(range.low), std::abs(range.high));
}

}  // namespace

ChartAxis axis_around(const Range& range, double free_share, bool logarithmic) {
    if (logarithmic) {
        if (range.low > range.high) return {0.1, 1.0, true};
        if (holds_one_value(range)) return {range.low / std::sqrt(10.0), range.high * std::sqrt(10.0), true};
        const double factor = std::pow(range.high / range.low, free_share);
        return {range.low / factor, range.high * factor, true};
    }
    if (range.low > range.high) return {0.0, 1.0};
    if (holds_one_value(range)) return {range.low - 0.5, range.high + 0.5};
    const double free = free_share * (range.high - range.low);
    return {range.low - free, range.high + free};
}

std::string draw_frame(const ChartFrame& frame, const std::string& x_label, const std::string& y_label,
                       bool grid) {
    const std::string line = "stroke=\"" + hex(palette::faint) + "\" stroke-width=\"0.7\"";
    const std::string tick = "stroke=\"" + hex(palette::ink) + "\"";
    std::string svg;
    const Ticks along = frame.x.ticks(12);
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const double x = frame.at_x(along.values[i]);
        svg += grid ? svg_line(x, frame.top, x, frame.bottom, line)
                    : svg_line(x, frame.bottom, x, frame.bottom + 4, tick);
        if (!x_label.empty() && !along.labels[i].empty())
            svg += svg_text(x, frame.bottom + 17, "middle", along.labels[i]);
    }
    const int count = std::max(2, static_cast<int>((frame.bottom - frame.top) / 30));
    const Ticks upward = frame.y.ticks(count);
    for (std::size_t i = 0; i < upward.values.size(); ++i) {
        const double y = frame.at_y(upward.values[i]);
        svg += grid ? svg_line(frame.left, y, frame.right, y, line)
                    : svg_line(frame.left - 4, y, frame.left, y, tick);
        if (!upward.labels[i].empty()) svg += svg_text(frame.left - 7, y + 4, "end", upward.labels[i]);
    }
    svg += svg_rectangle(frame.left, frame.top, frame.right, frame.bottom,
                         "fill=\"none\" stroke=\"" + hex(palette::ink) + "\"");
    svg += svg_text(0.5 * (frame.left + frame.right), frame.bottom + 40, "middle", x_label);
    const std::string place =
        svg_number(frame.left - 58) + " " + svg_number(0.5 * (frame.top + frame.bottom));
    svg += svg_text(0, 0, "middle", y_label, "transform=\"translate(" + place + ") rotate(-90)\"");
    return svg;
}

}  // namespace tidewater::io
