// The frame of a chart: where values lie on the page, ticks, grid and labels.
#pragma once

#include <limits>
#include <string>

#include "io/axis.h"

namespace tidewater::io {

// Holds all finite numbers that were included; empty at first.
struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void include(double value);
};

// Values from low to high, low < high; on a logarithmic axis both are > 0 and only values > 0 have a place.
struct ChartAxis {
    double low = 0.0, high = 1.0;
    bool logarithmic = false;

    // 0 at low, 1 at high; no number where the value has no place.
    double share(double value) const;
    Ticks ticks(int greatest_count) const;
};

// The axis that holds the range with this share of its length (of its decades on a logarithmic axis) free at
// both ends. A range with one value gets an axis of length 1 (a decade) around it, an empty one that from 0
// to 1 (0.1 to 1). What a logarithmic axis has no place for must not be in the range.
ChartAxis axis_around(const Range& range, double free_share, bool logarithmic);

// On the page, in pixels.
struct ChartFrame {
    double left, right, top, bottom;
    ChartAxis x, y;

    double at_x(double value) const { return left + (right - left) * x.share(value); }
    double at_y(double value) const { return bottom - (bottom - top) * y.share(value); }
};

// As SVG elements. x_label: empty where the axis is labelled below another frame; it then has no numbers
// either.
std::string draw_frame(const ChartFrame& frame, const std::string& x_label, const std::string& y_label,
                       bool grid = true);

}  // namespace tidewater::io
