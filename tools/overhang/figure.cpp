// The chart of overhang.svg.
#include <algorithm>
#include <cmath>

#include "cases.h"
#include "io/chart.h"
#include "io/text.h"

namespace tidewater::overhang {
namespace {

// Where D/H nears ρi/ρw all lengths grow without bound: curves end at this multiple of the greatest length
// that was measured, or that eq. 1 has for dry ice, or at what eq. 1 has for D = H if there are such cases.
constexpr double highest = 1.5;

// Over D/H from `from` to `to`; no higher than top.
struct Range {
    double from, to, top;
};

io::ChartLine curve(const Case& like, const Range& range, const std::string& label,
                    double (Case::*theory)() const) {
    io::ChartLine line{.label = label, .x = {}, .y = {}};
    constexpr int steps = 1000;
    for (int i = 0; i <= steps; ++i) {
        Case at = like;
        line.x.push_back(range.from + (range.to - range.from) * static_cast<double>(i) / steps);
        at.overhang.depth = line.x.back() * like.overhang.height;
        const double ratio = (at.*theory)();
        line.y.push_back(ratio <= range.top ? ratio : analysis::none);
    }
    return line;
}

io::ChartLine dashed(io::ChartLine line, std::size_t color) {
    line.dashed = true;
    line.color = color;
    return line;
}

io::ChartLine faint(io::ChartLine line) {
    line.dashed = line.faint = true;
    return line;
}

io::ChartMark iceberg_mark(const Case& c) {
    io::ChartMark mark{.label = "Li, first crack from top",
                       .shape = io::MarkShape::point_down,
                       .x = c.depth_ratio(),
                       .y = c.length_ratio,
                       .color = 3,
                       .note = {}};
    if (!c.came_off()) {
        mark.label = "no iceberg";
        mark.shape = io::MarkShape::beyond;
    } else if (analysis::crack_start(c.crack_start_height) == analysis::CrackStart::bottom) {
        mark.label = "Li, from bottom";
        mark.shape = io::MarkShape::point_up;
    } else if (analysis::crack_start(c.crack_start_height) == analysis::CrackStart::inside) {
        mark.label = "Li, from inside";
        mark.shape = io::MarkShape::dot;
    }
    return mark;
}

io::ChartMark overhang_mark(const Case& c) {
    return {.label = "overhang L",
            .shape = io::MarkShape::ring,
            .x = c.depth_ratio(),
            .y = c.overhang_ratio,
            .color = 4,
            .note = {}};
}

// "0.5 MPa"
std::string megapascals(double pressure) { return io::format_fixed(1e-6 * pressure, 2) + " MPa"; }

io::ChartPanel panel(std::vector<Case>::const_iterator begin, std::vector<Case>::const_iterator end) {
    Case dry = *begin;
    dry.overhang.depth = 0.0;
    double top = std::max(dry.eq1(), dry.uniaxial_beam()), deepest = 0.0;
    for (auto c = begin; c != end; ++c) {
        deepest = std::max(deepest, c->depth_ratio());
        for (const double measured : {c->length_ratio, c->overhang_ratio}) top = std::fmax(top, measured);
    }
    top *= highest;
    if (deepest >= 1.0) {
        Case level = *begin;
        level.overhang.depth = level.overhang.height;
        top = std::max(top, level.eq1() * (1.0 + 1e-9));
    }
    const Range range{0.0, std::max(deepest, 1.0), top};
    io::ChartPanel panel{.title = {}, .y_label = "Li/H, L/H", .lines = {}, .marks = {}};
    panel.title = "H = " + io::format_number(begin->overhang.height) +
                  " m, βp0 = " + megapascals(begin->strength) + ", uniaxial strength " +
                  megapascals(begin->uniaxial_strength);
    panel.lines = {curve(*begin, range, "eq. 1", &Case::eq1),
                   dashed(curve(*begin, range, "beam, βp0", &Case::beam), 1),
                   dashed(curve(*begin, range, "beam, uniaxial strength", &Case::uniaxial_beam), 2)};
    if (deepest > 1.0) {
        const Range above{1.0, deepest, top};
        panel.lines.push_back(faint(curve(*begin, above, "eq. 1, submerged", &Case::eq1_submerged)));
    }
    for (auto c = begin; c != end; ++c) panel.marks.push_back(iceberg_mark(*c));
    for (auto c = begin; c != end; ++c) {
        if (std::isfinite(c->overhang_ratio)) panel.marks.push_back(overhang_mark(*c));
    }
    return panel;
}

}  // namespace

std::string draw_cases(const std::vector<Case>& cases, const Provenance& provenance) {
    io::Chart chart{.title = "Length of the first iceberg, and of the overhang it came off",
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
