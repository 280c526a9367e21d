#include "io/panel.h"

#include <algorithm>
#include <cmath>

#include "io/axis.h"

namespace tidewater::io {

Pixel Panel::at(double across, double upward) const {
    return {low.x + (across - left) / (right - left) * (high.x - low.x),
            high.y - (upward - bottom) / (top - bottom) * (high.y - low.y)};
}

double Panel::across(double pixel_x) const {
    return left + (pixel_x - low.x) / (high.x - low.x) * (right - left);
}

double Panel::upward(double pixel_y) const {
    return bottom + (high.y - pixel_y) / (high.y - low.y) * (top - bottom);
}

void draw_axes(Drawing& drawing, const Panel& panel, double unit) {
    const double u = unit, thin = 1.5 * u, letters = std::max(19.0 * u, 9.0);
    const Pixel low = panel.low, high = panel.high;
    for (const auto& [from, to] :
         {std::pair{low, Pixel{high.x, low.y}}, std::pair{Pixel{low.x, high.y}, high},
          std::pair{low, Pixel{low.x, high.y}}, std::pair{Pixel{high.x, low.y}, high}})
        drawing.line(from, to, thin, palette::ink);
    const auto greatest_count = [](double length, double each) {
        return std::max(2, static_cast<int>(length / each));
    };
    const Ticks along = make_ticks(panel.left, panel.right, greatest_count(high.x - low.x, 85 * u));
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const double x = panel.at(along.values[i], panel.bottom).x;
        drawing.line({x, high.y}, {x, high.y + 6 * u}, thin, palette::ink);
        drawing.text({x, high.y + 20 * u}, Align::center, letters, along.labels[i]);
    }
    drawing.text({0.5 * (low.x + high.x), high.y + 46 * u}, Align::center, letters, panel.across_label);
    const Ticks upward =
        make_ticks(panel.bottom, panel.top, std::min(12, greatest_count(high.y - low.y, 45 * u)));
    for (std::size_t i = 0; i < upward.values.size(); ++i) {
        const double y = panel.at(panel.left, upward.values[i]).y;
        drawing.line({low.x - 6 * u, y}, {low.x, y}, thin, palette::ink);
        drawing.text({low.x - 11 * u, y}, Align::right, letters, upward.labels[i]);
    }
    drawing.text({low.x - 6 * u, low.y - 25 * u}, Align::right, letters, panel.upward_label);
}

}  // namespace tidewater::io
