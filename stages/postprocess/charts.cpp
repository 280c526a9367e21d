#include "charts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/chart.h"
#include "io/rasterise.h"
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

// In J, kJ, MJ, … so that the axis needs at most four digits.
void use_energy_unit(io::ChartPanel& panel, bool per_width) {
    constexpr std::array units{"J", "kJ", "MJ", "GJ", "TJ", "PJ"};
    double greatest = 0.0, scale = 1.0;
    for (const io::ChartLine& line : panel.lines) {
        for (const double value : line.y) greatest = std::fmax(greatest, std::abs(value));
    }
    std::size_t unit = 0;
    for (; greatest >= 1e4 * scale && unit + 1 < units.size(); ++unit) scale *= 1000.0;
    for (io::ChartLine& line : panel.lines) {
        for (double& value : line.y) value /= scale;
    }
    panel.y_label = std::string("energy (") + units[unit] + (per_width ? " per m of width)" : ")");
}

}  // namespace

void write_chart(const StageContext& context, const std::string& name, const std::string& svg) {
    io::write_svg_and_png(context.folder / (name + ".svg"), svg, io::chart_scale, context.provenance);
}

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
    const auto *friction = ledger.find("friction_work"), *drag = ledger.find("drag_work");
    if (friction && drag && (friction->back() != 0.0 || drag->back() != 0.0)) {
        std::vector<double> both = *friction;
        for (std::size_t i = 0; i < both.size(); ++i) both[i] += (*drag)[i];
        panel.lines.push_back(
            {.label = "work of friction and drag", .x = time, .y = both, .color = 5, .dashed = true});
    }
    use_energy_unit(panel, context.scene.dimension == 2);
    return io::draw_chart(
        {.title = context.scene.title, .x_label = "time (s)", .panels = {panel}, .panel_height = 360.0},
        context.provenance);
}

std::string body_chart(const std::vector<Body>& bodies, const StageContext& context) {
    io::Chart chart{.title = context.scene.title, .x_label = "time (s)", .panels = {}, .panel_height = 180.0};
    const auto panel = [&](const char* label, std::vector<double> Body::*values) {
        io::ChartPanel& added = chart.panels.emplace_back();
        added.y_label = label;
        for (const Body& body : bodies) {
            io::ChartLine& line = added.lines.emplace_back();
            if (bodies.size() > 1) line.label = "block " + std::to_string(body.number);
            line.x = body.time;
            line.y = body.*values;
            line.color = static_cast<std::size_t>(body.number) - 1;
        }
    };
    panel("z of the centre (m)", &Body::height);
    panel("angle (°)", &Body::angle);
    panel("fastest point (m/s)", &Body::fastest);
    return io::draw_chart(chart, context.provenance);
}

std::string energy_split_chart(const EnergySplit& split, const StageContext& context) {
    io::ChartPanel panel;
    panel.y_label =
        context.scene.dimension == 2 ? "change since the start (J per m)" : "change since the start (J)";
    const auto line = [&](const char* label, const std::vector<double>& values, std::size_t color) {
        panel.lines.push_back({.label = label, .x = split.time, .y = values, .color = color});
    };
    line(context.scene.has("ice") ? "water and ice" : "water", split.water, 0);
    line("block", split.block, 1);
    line("lost", split.lost, 2);
    if (std::ranges::any_of(split.brought, [](double value) { return value != 0.0; }))
        line("brought through the boundaries", split.brought, 3);
    return io::draw_chart(
        {.title = context.scene.title, .x_label = "time (s)", .panels = {panel}, .panel_height = 360.0},
        context.provenance);
}

std::string first_wave_chart(const Tsunami& tsunami, const StageContext& context) {
    io::ChartPanel amplitude{.title = {}, .y_label = "amplitude / greatest", .lines = {}, .marks = {}};
    io::ChartPanel position{.title = {}, .y_label = "distance run (m)", .lines = {}, .marks = {}};
    double latest = 0.0;
    for (const WaveWay& way : tsunami.ways) {
        const analysis::FirstWave& wave = way.wave;
        if (wave.track.empty()) continue;
        io::ChartLine line{.label = {}, .x = {}, .y = {}, .color = amplitude.lines.size(), .dots = true};
        line.label = std::string("to the ") + (way.to_the_right() ? "right" : "left") + ", at most " +
                     io::format_fixed(wave.greatest.amplitude, 4) + " m";
        for (const auto& crest : wave.track) line.x.push_back(crest.time - wave.greatest.time);
        io::ChartLine run = line;
        for (const auto& crest : wave.track) {
            line.y.push_back(crest.amplitude / wave.greatest.amplitude);
            run.y.push_back(crest.distance - wave.greatest.distance);
        }
        latest = std::max(latest, line.x.back());
        amplitude.lines.push_back(line);
        position.lines.push_back(run);
    }
    const double speed = tsunami.long_wave_celerity;
    position.lines.push_back({.label = "√(gD) t, √(gD) = " + io::format_fixed(speed, 2) + " m/s",
                              .x = {0.0, latest},
                              .y = {0.0, latest * speed},
                              .color = 3,
                              .dashed = true});
    return io::draw_chart({.title = context.scene.title,
                           .x_label = "time since the greatest amplitude (s)",
                           .panels = {amplitude, position},
                           .width = 760.0,
                           .panel_height = 280.0},
                          context.provenance);
}

}  // namespace tidewater::postprocess
