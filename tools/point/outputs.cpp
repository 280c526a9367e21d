#include "outputs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "io/chart.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::point {
namespace {

using mpm::PointRow;

constexpr std::size_t surface_color = 0, path_color = 1, p0_color = 2, q_color = 3, p_color = 5;

// Pressures of a chart in one unit.
struct Unit {
    double pascals;
    std::string name;
};

std::string text(const char* format, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

template <class Value>
std::vector<double> column(const std::vector<PointRow>& rows, double unit, Value value) {
    std::vector<double> values;
    for (const PointRow& row : rows) values.push_back(std::invoke(value, row) / unit);
    return values;
}

double apex(const mpm::IceModel& ice, double p0) {  // greatest q of a surface, Pa
    return 0.5 * ice.friction * p0 * (1 + ice.beta) / std::sqrt(1 + 2 * ice.beta);
}

// q = M √((p+βp0)(p0−p)/(1+2β)), half an ellipse around pc.
io::ChartLine surface(const mpm::IceModel& ice, double p0, const Unit& unit) {
    io::ChartLine line{.label = {}, .x = {}, .y = {}, .color = surface_color};
    constexpr int count = 180;
    for (int i = 0; i <= count; ++i) {
        const double angle = std::numbers::pi * i / count;
        line.x.push_back(0.5 * p0 * ((1 - ice.beta) - (1 + ice.beta) * std::cos(angle)) / unit.pascals);
        line.y.push_back(apex(ice, p0) * std::sin(angle) / unit.pascals);
    }
    return line;
}

// The first p0 on the path below two and below one third of the start's, and the largest if it is above.
std::vector<double> later_p0(const std::vector<PointRow>& rows, double start) {
    std::vector<double> found;
    for (const double share : {2.0 / 3.0, 1.0 / 3.0}) {
        const auto row =
            std::ranges::find_if(rows, [&](const PointRow& of) { return of.p0 < share * start; });
        if (row != rows.end() && row->p0 > 0.1 * share * start) found.push_back(row->p0);
    }
    const double largest = std::ranges::max_element(rows, {}, &PointRow::p0)->p0;
    if (largest > 1.05 * start) found.push_back(largest);
    return found;
}

io::ChartLine line_of(const std::vector<PointRow>& rows, const Unit& unit, const std::string& label,
                      double PointRow::*value, std::size_t color) {
    return {.label = label,
            .x = column(rows, 1.0, &PointRow::strain),
            .y = column(rows, unit.pascals, value),
            .color = color};
}

// At least `gap` apart on the page; width and height are the extents of the panel.
io::ChartLine dots_of(const io::ChartLine& path, double width, double height) {
    constexpr double gap = 1.0 / 30;
    io::ChartLine dots{.label = "path", .x = {}, .y = {}, .color = path_color, .dots = true};
    for (std::size_t i = 0; i < path.x.size(); ++i) {
        if (!dots.x.empty() &&
            std::hypot((path.x[i] - dots.x.back()) / width, (path.y[i] - dots.y.back()) / height) < gap)
            continue;
        dots.x.push_back(path.x[i]);
        dots.y.push_back(path.y[i]);
    }
    return dots;
}

io::ChartMark mark_at(const PointRow& row, const Unit& unit, const char* note) {
    return {.label = {},
            .x = row.pressure / unit.pascals,
            .y = row.q / unit.pascals,
            .color = path_color,
            .note = note};
}

io::ChartPanel surface_panel(const mpm::IceModel& ice, const std::vector<PointRow>& rows, const Unit& unit) {
    const double start = ice.beta_p0 / ice.beta;
    io::ChartPanel panel{.title = "yield surface",
                         .y_label = "q (" + unit.name + ")",
                         .lines = {},
                         .marks = {},
                         .x_label = "p (" + unit.name + "), positive in compression",
                         .height = 380.0};
    double largest = start;
    const double top = 1.1 * apex(ice, start);
    panel.lines.push_back({.label = "q = M p",
                           .x = {0.0, top / ice.friction / unit.pascals},
                           .y = {0.0, top / unit.pascals},
                           .dashed = true,
                           .faint = true});
    panel.lines.push_back(surface(ice, start, unit));
    panel.lines.back().label = "surface of intact ice";
    for (const double p0 : later_p0(rows, start)) {
        panel.lines.push_back(surface(ice, p0, unit));
        panel.lines.back().label = "later";
        panel.lines.back().dashed = true;
        largest = std::max(largest, p0);
    }
    io::ChartLine path{.label = {},
                       .x = column(rows, unit.pascals, &PointRow::pressure),
                       .y = column(rows, unit.pascals, &PointRow::q),
                       .color = path_color};
    const io::ChartLine dots =
        dots_of(path, (1 + ice.beta) * largest / unit.pascals, apex(ice, largest) / unit.pascals);
    panel.lines.push_back(path);
    panel.lines.push_back(dots);
    panel.marks.push_back({.label = {},
                           .shape = io::MarkShape::rule,
                           .x = 0.5 * (1 - ice.beta) * start / unit.pascals,
                           .color = surface_color,
                           .note = "pc of intact ice"});
    const auto onset = mpm::find_milestones(rows).onset;
    if (onset && rows.front().p0 > 0) panel.marks.push_back(mark_at(*onset, unit, "first yield"));
    panel.marks.push_back(mark_at(rows.back(), unit, "end"));
    return panel;
}

std::string path_title(const Options& options) {
    constexpr std::array<const char*, 4> names{"isotropic strain", "uniaxial loading", "uniaxial strain",
                                               "pure shear"};
    const mpm::IceModel& ice = options.ice;
    std::string title = "Ice under " + std::string(names[static_cast<std::size_t>(options.loading.path)]);
    if (options.loading.held_pressure)
        title += " at " + text("%g", *options.loading.held_pressure / 1e6) + " MPa";
    return title + ": E = " + text("%g", ice.youngs_modulus / 1e9) +
           " GPa, βp0 = " + text("%g", ice.beta_p0 / 1e6) + " MPa, β = " + text("%g", ice.beta) +
           ", M = " + text("%g", ice.friction) + ", ξ = " + text("%g", ice.hardening) + ", " +
           std::to_string(options.dimension) + "D";
}

std::string strain_label(mpm::LoadPath path) {
    switch (path) {
        case mpm::LoadPath::isotropic:
            return "volume strain ln J";
        case mpm::LoadPath::shear:
            return "shear strain γ";
        default:
            return "axial strain, logarithmic";
    }
}

Unit unit_for(const mpm::IceModel& ice, const std::vector<PointRow>& rows) {
    const double largest =
        std::max(std::ranges::max_element(rows, {}, &PointRow::p0)->p0, ice.beta_p0 / ice.beta);
    return largest < 2e6 ? Unit{1e3, "kPa"} : Unit{1e6, "MPa"};
}

std::string milestone(const char* name, const std::optional<PointRow>& row) {
    if (!row) return std::string(name) + "  not on this path\n";
    return std::string(name) + "  strain " + text("%.4g", row->strain) + ", p " +
           text("%.1f", row->pressure / 1e3) + " kPa, q " + text("%.1f", row->q / 1e3) + " kPa\n";
}

}  // namespace

void write_csv(const std::filesystem::path& path, const std::vector<PointRow>& rows,
               const Provenance& provenance) {
    io::TableWriter table(
        path, provenance,
        {"step", "strain", "log_volume", "p", "q", "p0", "alpha", "damage", "dissipated", "case"});
    for (const PointRow& row : rows) {
        std::vector<std::string> cells{std::to_string(row.step)};
        for (const double value :
             {row.strain, row.log_volume, row.pressure, row.q, row.p0, row.alpha, row.damage, row.dissipated})
            cells.push_back(io::format_number(value));
        cells.emplace_back(mpm::yield_case_names[static_cast<std::size_t>(row.applied)]);
        table.append_cells(cells);
    }
    table.finish();
}

std::string draw_path(const Options& options, const std::vector<PointRow>& rows,
                      const Provenance& provenance) {
    const Unit unit = unit_for(options.ice, rows);
    io::ChartPanel stress{
        .title = {}, .y_label = "p, q (" + unit.name + ")", .lines = {}, .marks = {}, .height = 190.0};
    stress.lines = {line_of(rows, unit, "p", &PointRow::pressure, p_color),
                    line_of(rows, unit, "q", &PointRow::q, q_color)};
    io::ChartPanel strength{
        .title = {}, .y_label = "p0 (" + unit.name + ")", .lines = {}, .marks = {}, .height = 110.0};
    strength.lines = {line_of(rows, unit, "p0", &PointRow::p0, p0_color)};
    io::Chart chart{
        .title = path_title(options), .x_label = strain_label(options.loading.path), .panels = {}};
    chart.panels = {surface_panel(options.ice, rows, unit), stress, strength};
    return io::draw_chart(chart, provenance);
}

std::string summary(const Options& options, const std::vector<PointRow>& rows) {
    const mpm::IceModel& ice = options.ice;
    const int d = options.dimension;
    const double stability = ice.beta * ice.hardening;
    const auto kpa = [](double pascals) { return text("%.1f", pascals / 1e3) + " kPa\n"; };
    const mpm::Milestones found = mpm::find_milestones(rows);
    return "p0 at the start               " + kpa(ice.beta_p0 / ice.beta) + "α0                            " +
           text("%.4g", ice.initial_alpha(d)) + "\n" + "βξ                            " +
           text("%.4g", stability) +
           (stability < 1 ? ": softening in isotropic tension is stable\n"
                          : ": softening in isotropic tension snaps to failure\n") +
           "isotropic tension yields at   ln J = " + text("%.4g", mpm::tension_onset(ice, d)) + "\n" +
           "pure shear yields at          q = " + kpa(mpm::shear_strength(ice)) +
           "uniaxial tensile strength     " + kpa(ice.uniaxial_strength(d)) +
           "uniaxial crushing strength    " + kpa(mpm::uniaxial_crushing_strength(ice, d)) +
           "a crack dissipates            " +
           text("%.4g", mpm::crack_band_hardening(ice, d, 1.0, 1.0) / ice.hardening) +
           " J/m³ in uniaxial tension, if it does not snap\n" +
           milestone("this path: first yield      ", found.onset) +
           milestone("           greatest q       ", found.max_q) +
           milestone("           strength is lost ", found.failure) + "           dissipated         " +
           text("%.4g", rows.back().dissipated) + " J/m³\n";
}

}  // namespace tidewater::point
