#include "io/plan.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "io/axis.h"

namespace tidewater::io {
namespace {

// What is seen at a panel's pixels, row by row from above.
struct View {
    int columns = 0, rows = 0;
    double metres = 1.0;  // per pixel
    std::vector<Top> tops;

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(std::clamp(row, 0, rows - 1)) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(std::clamp(column, 0, columns - 1));
    }
    const Top& at(int column, int row) const { return tops[index(column, row)]; }
    double depth(int column, int row) const { return at(column, row).height - at(column, row).bed; }
    bool is(Substance substance, int column, int row) const { return at(column, row).substance == substance; }
};

View look_down(const Panel& panel, const std::function<Top(double, double)>& top) {
    View view;
    view.columns = static_cast<int>(std::lround(panel.high.x - panel.low.x));
    view.rows = static_cast<int>(std::lround(panel.high.y - panel.low.y));
    view.metres = (panel.right - panel.left) / view.columns;
    view.tops.resize(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows));
    parallel_for(static_cast<std::size_t>(view.rows), [&](std::size_t row) {
        const double y = panel.upward(panel.low.y + static_cast<double>(row) + 0.5);
        for (int column = 0; column < view.columns; ++column) {
            view.tops[view.index(column, static_cast<int>(row))] =
                top(panel.across(panel.low.x + column + 0.5), y);
        }
    });
    return view;
}

// The light on a surface over that on level ground, from the upper left; a step to another substance is none.
double light(const View& view, int column, int row) {
    const Top& own = view.at(column, row);
    const auto height = [&](int at_column, int at_row) {
        const Top& other = view.at(at_column, at_row);
        return other.substance == own.substance ? other.height : own.height;
    };
    const double right = (height(column + 1, row) - height(column - 1, row)) / (2.0 * view.metres);
    const double up = (height(column, row - 1) - height(column, row + 1)) / (2.0 * view.metres);
    constexpr double steepness = 1.3;  // of the light: its height over its reach along each axis
    const double lit = (right - up + steepness) / steepness / std::sqrt(1.0 + right * right + up * up);
    return lit > 1.0 ? 1.0 + 0.3 * std::min(lit - 1.0, 1.0) : std::max(lit, 0.4);
}

struct Range {
    double greatest_depth = 0.0, greatest_height = 0.0;  // of water; of ice above the still level
};

Range range_of(const View& view, double still_level) {
    Range range;
    for (const Top& top : view.tops) {
        if (top.substance == Substance::water)
            range.greatest_depth = std::max(range.greatest_depth, top.height - top.bed);
        if (top.substance == Substance::ice)
            range.greatest_height = std::max(range.greatest_height, top.height - still_level);
    }
    return range;
}

// Of the depths at which contours lie.
Ticks contours_of(const Range& range) { return make_ticks(0.0, std::max(range.greatest_depth, 1e-9), 10); }

void draw_surfaces(Canvas& canvas, const View& view, const Range& range, double still_level) {
    const Ticks contours = contours_of(range);
    const double step = contours.values.size() > 1 ? contours.values[1] - contours.values[0] : 1.0;
    const auto band = [&](int column, int row) { return std::floor(view.depth(column, row) / step); };
    for (int row = 0; row < view.rows; ++row) {
        for (int column = 0; column < view.columns; ++column) {
            const Top& top = view.at(column, row);
            Color color = substance_color(top.substance);
            if (top.substance == Substance::water) {
                color = depth_color((top.height - top.bed) / std::max(range.greatest_depth, 1e-9));
                const auto crosses = [&](int other_column, int other_row) {
                    return view.is(Substance::water, other_column, other_row) &&
                           band(other_column, other_row) != band(column, row);
                };
                if (crosses(column + 1, row) || crosses(column, row + 1)) color = shaded(color, 0.6);
            } else if (top.substance != Substance::nothing) {
                if (top.substance == Substance::ice)
                    color =
                        ice_height_color((top.height - still_level) / std::max(range.greatest_height, 1e-9));
                color = shaded(color, light(view, column, row));
            }
            canvas.blend(column, row, color);
        }
    }
}

constexpr int opening = 4;  // pixels to each side that are free of ice in open water

// Water that is open, or no farther from such water than the opening.
std::vector<std::uint8_t> open_water(const View& view) {
    const auto any_within = [&](int reach, const auto& holds) {
        std::vector<std::uint8_t> found(view.tops.size());
        parallel_for(static_cast<std::size_t>(view.rows), [&](std::size_t at_row) {
            const auto row = static_cast<int>(at_row);
            for (int column = 0; column < view.columns; ++column) {
                for (int n = 0; n < (2 * reach + 1) * (2 * reach + 1) && !found[view.index(column, row)];
                     ++n) {
                    const int i = column + n % (2 * reach + 1) - reach, j = row + n / (2 * reach + 1) - reach;
                    found[view.index(column, row)] = holds(i, j);
                }
            }
        });
        return found;
    };
    const auto near_ice = any_within(opening, [&](int i, int j) { return view.is(Substance::ice, i, j); });
    return any_within(opening + 1, [&](int i, int j) {
        return view.is(Substance::water, i, j) && !near_ice[view.index(i, j)];
    });
}

void draw_front(Canvas& canvas, const View& view, double unit) {
    const auto open = open_water(view);
    const auto reach = static_cast<int>(std::lround(1.3 * unit));
    for (int row = 0; row < view.rows; ++row) {
        for (int column = 0; column < view.columns; ++column) {
            if (!view.is(Substance::ice, column, row)) continue;
            const auto meets = [&](int i, int j) {
                return view.is(Substance::water, i, j) && open[view.index(i, j)];
            };
            if (!meets(column - 1, row) && !meets(column + 1, row) && !meets(column, row - 1) &&
                !meets(column, row + 1))
                continue;
            for (int j = row - reach; j <= row + reach; ++j) {
                for (int i = column - reach; i <= column + reach; ++i) canvas.blend(i, j, front_color);
            }
        }
    }
}

double bar_height(const Panel& panel, double unit) {
    return std::clamp(0.36 * (panel.high.y - panel.low.y), 110 * unit, 300 * unit);
}

// `lines` are the values of contours.
template <class ColorOf>
void draw_bar(Drawing& drawing, Pixel corner, double height, double unit, const std::string& title,
              double greatest, const ColorOf& color, const std::vector<double>& lines) {
    const double u = unit, letters = std::max(17.0 * u, 9.0), width = 26 * u;
    drawing.text({corner.x, corner.y + 8 * u}, Align::left, letters, title);
    const double top = corner.y + 28 * u, bottom = top + height;
    const auto place = [&](double value) { return bottom - height * value / greatest; };
    drawing.rectangle({corner.x - 1.5 * u, top - 1.5 * u}, {corner.x + width + 1.5 * u, bottom + 1.5 * u},
                      palette::ink);
    drawing.color_bar({corner.x, top}, {corner.x + width, bottom}, color, true);
    for (const double value : lines)
        drawing.line({corner.x, place(value)}, {corner.x + width, place(value)}, u,
                     shaded(color(value / greatest), 0.6));
    const Ticks ticks = make_ticks(0.0, greatest, std::max(2, static_cast<int>(height / (27 * u))));
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y = place(ticks.values[i]);
        drawing.line({corner.x + width, y}, {corner.x + width + 6 * u, y}, 1.5 * u, palette::ink);
        drawing.text({corner.x + width + 11 * u, y}, Align::left, letters, ticks.labels[i]);
    }
}

}  // namespace

void draw_plan(Drawing& drawing, const Panel& panel, const std::function<Top(double, double)>& top,
               double still_level, double unit) {
    const View view = look_down(panel, top);
    const Range range = range_of(view, still_level);
    Canvas canvas(view.columns, view.rows);
    draw_surfaces(canvas, view, range, still_level);
    draw_front(canvas, view, unit);
    drawing.image(canvas, panel.low);
    Pixel corner{panel.high.x + 26 * unit, panel.low.y};
    if (range.greatest_height > 0.0) {
        draw_bar(drawing, corner, bar_height(panel, unit), unit, "ice above water (m)", range.greatest_height,
                 ice_height_color, {});
        corner.y += bar_height(panel, unit) + 70 * unit;
    }
    if (range.greatest_depth > 0.0) {
        draw_bar(drawing, corner, bar_height(panel, unit), unit, "water depth (m)", range.greatest_depth,
                 depth_color, contours_of(range).values);
    }
}

double plan_bars_height(const Panel& panel, double unit) {
    return 2.0 * bar_height(panel, unit) + 110 * unit;
}

Color depth_color(double share) { return mixed({206, 226, 240}, {18, 52, 108}, share); }

Color ice_height_color(double share) { return mixed({168, 200, 206}, {250, 252, 253}, share); }

}  // namespace tidewater::io
