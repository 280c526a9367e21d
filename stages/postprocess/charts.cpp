#include "charts.h"

#include <algorithm>
#include <cmath>

#include "io/chart.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

std::vector<double> change(const std::vector<double>& values) {
    std::vector<double> result;
    for (const double value : values) result.push_back(value - values.front());
    return result;
}

io::ChartLine positions(const Waves& waves, const char* label, double analysis::GaugeWave::*time,
                        std::size_t color) {
    io::ChartLine line{.label = label, .x = {}, .y = {}, .color = color, .dots = true};
    for (const auto& gauge : waves.gauges) {
        if (std::isnan(gauge.*time)) continue;
        line.x.push_back(gauge.*time);
        line.y.push_back(gauge.x);
    }
    return line;
}

// "x = 2 m", "x = 2 m, y = 0.5 m"
std::string place_title(const io::NamedPlace& place) {
    std::string title = "x = " + io::format_number(*place.x) + " m";
    if (place.y) title += ", y = " + io::format_number(*place.y) + " m";
    return title;
}

}  // namespace

std::string gauge_chart(const Waves& waves, const StageContext& context) {
    io::Chart chart{.title = context.scene.title, .x_label = "time (s)", .panels = {}, .one_y_range = true};
    for (std::size_t i = 0; i < waves.records.size(); ++i) {
        const GaugeRecord& record = waves.records[i];
        const analysis::GaugeWave& gauge = waves.gauges[i];
        io::ChartPanel panel;
        panel.title = place_title(record.place) + (record.source == "run" ? "" : ", from snapshots");
        panel.y_label = "η (m)";
        panel.lines = {{.label = "surface elevation η", .x = record.time, .y = record.elevation}};
        panel.marks = {
            {.label = "arrival", .shape = io::MarkShape::rule, .x = gauge.arrival, .color = 2, .note = {}},
            {.label = "leading crest", .x = gauge.crest_time, .y = gauge.crest, .note = {}},
        };
        if (!record.time.empty() && gauge.record_end < record.time.back()) {
            panel.marks.push_back({.label = "reflection may be back",
                                   .shape = io::MarkShape::rule,
                                   .x = gauge.record_end,
                                   .color = 3,
                                   .note = {}});
        }
        chart.panels.push_back(panel);
    }
    return io::draw_chart(chart, context.provenance);
}

std::string celerity_chart(const Waves& waves, const StageContext& context) {
    const io::ChartLine crests = positions(waves, "leading crest", &analysis::GaugeWave::crest_time, 1);
    const io::ChartLine arrivals = positions(waves, "arrival", &analysis::GaugeWave::arrival, 2);
    io::ChartPanel panel{.title = {}, .y_label = "x (m)", .lines = {crests, arrivals}, .marks = {}};
    if (!crests.x.empty()) {
        const double speed = waves.long_wave_celerity;
        io::ChartLine reference{
            .label = "√(gD) = " + io::format_fixed(speed, 2) + " m/s from the first crest",
            .x = {crests.x.front(), crests.x.front() + (crests.y.back() - crests.y.front()) / speed},
            .y = {crests.y.front(), crests.y.back()},
            .color = 0,
            .dashed = true};
        panel.lines.push_back(reference);
    }
    return io::draw_chart({.title = context.scene.title,
                           .x_label = "time (s)",
                           .panels = {panel},
                           .width = 760.0,
                           .panel_height = 360.0},
                          context.provenance);
}

std::string energy_chart(const io::Table& ledger, const std::filesystem::path& path,
                         const StageContext& context) {
    const auto& time = io::require_column(ledger, "time", path);
    io::ChartPanel panel;
    panel.y_label = context.scene.dimension == 2 ? "energy (J per m of width)" : "energy (J)";
    std::vector<double> total(time.size(), 0.0);
    for (const char* name : {"kinetic", "gravitational", "elastic"}) {
        const auto values = change(io::require_column(ledger, name, path));
        for (std::size_t i = 0; i < total.size(); ++i) total[i] += values[i];
        panel.lines.push_back(
            {.label = std::string(name) + ", change", .x = time, .y = values, .color = panel.lines.size()});
    }
    panel.lines.push_back({.label = "their sum", .x = time, .y = total, .color = 3});
    panel.lines.push_back({.label = "work at the boundaries",
                           .x = time,
                           .y = change(io::require_column(ledger, "boundary_work", path)),
                           .color = 4,
                           .dashed = true});
    return io::draw_chart(
        {.title = context.scene.title, .x_label = "time (s)", .panels = {panel}, .panel_height = 360.0},
        context.provenance);
}

}  // namespace tidewater::postprocess
