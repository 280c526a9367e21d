// The chart of overhang.svg.
#include <algorithm>
#include <cmath>

#include "cases.h"
#include "io/chart.h"
#include "io/text.h"

namespace tidewater::overhang {
namespace {

// Where D/H nears ρi/ρw all lengths grow without bound: curves end at this multiple of the greatest length
// that was measured, or that eq. 1 has for dry ice.
constexpr double highest = 1.5;

io::ChartLine curve(const Case& like, double top, std::size_t color, bool dashed, const std::string& label,
                    double (Case::*theory)() const) {
    io::ChartLine line{.label = label, .x = {}, .y = {}, .color = color, .dashed = dashed};
    constexpr int steps = 1000;
    for (int i = 0; i <= steps; ++i) {
        Case at = like;
        line.x.push_back(static_cast<double>(i) / steps);
        at.overhang.depth = line.x.back() * like.overhang.height;
        const double ratio = (at.*theory)();
        line.y.push_back(ratio <= top ? ratio : analysis::none);
    }
    return line;
}

io::ChartMark mark(const Case& c) {
    io::ChartMark mark{.label = "crack from top",
                       .shape = io::MarkShape::point_down,
                       .x = c.depth_ratio(),
                       .y = c.length_ratio,
                       .color = 3,
                       .note = {}};
    if (!c.came_off()) {
        mark.label = "no iceberg";
        mark.shape = io::MarkShape::beyond;
    } else if (analysis::crack_start(c.start_height) == analysis::CrackStart::bottom) {
        mark.label = "from bottom";
        mark.shape = io::MarkShape::point_up;
    } else if (analysis::crack_start(c.start_height) == analysis::CrackStart::inside) {
        mark.label = "from inside";
        mark.shape = io::MarkShape::dot;
    }
    return mark;
}

// "0.5 MPa"
std::string megapascals(double pressure) { return io::format_fixed(1e-6 * pressure, 2) + " MPa"; }

io::ChartPanel panel(std::vector<Case>::const_iterator begin, std::vector<Case>::const_iterator end) {
    Case dry = *begin;
    dry.overhang.depth = 0.0;
    double top = std::max(dry.eq1(), dry.uniaxial_beam());
    for (auto c = begin; c != end; ++c) {
        if (c->came_off()) top = std::max(top, c->length_ratio);
    }
    top *= highest;
    io::ChartPanel panel{.title = {}, .y_label = "Li/H", .lines = {}, .marks = {}};
    panel.title = "H = " + io::format_number(begin->overhang.height) +
                  " m, βp0 = " + megapascals(begin->strength) + ", uniaxial strength " +
                  megapascals(begin->uniaxial_strength);
    panel.lines = {curve(*begin, top, 0, false, "eq. 1", &Case::eq1),
                   curve(*begin, top, 1, true, "beam, βp0", &Case::beam),
                   curve(*begin, top, 2, true, "beam, uniaxial strength", &Case::uniaxial_beam)};
    for (auto c = begin; c != end; ++c) panel.marks.push_back(mark(*c));
    return panel;
}

}  // namespace

std::string draw_cases(const std::vector<Case>& cases, const Provenance& provenance) {
    io::Chart chart{.title = "Length of the first iceberg",
                    .x_label = "D/H",
                    .panels = {},
                    .width = 1040.0,
                    .panel_height = 380.0};
    for (auto begin = cases.begin(); begin != cases.end();) {
        const auto end = std::find_if(begin, cases.end(), [&](const Case& c) { return !c.alike(*begin); });
        chart.panels.push_back(panel(begin, end));
        begin = end;
    }
    return io::draw_chart(chart, provenance);
}

}  // namespace tidewater::overhang
