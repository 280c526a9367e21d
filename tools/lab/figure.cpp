// The chart of lab.svg.
#include <algorithm>
#include <cmath>

#include "cases.h"
#include "io/chart.h"
#include "io/text.h"

namespace tidewater::lab {
namespace {

// "GF: 0.141 m, 3.00 m/s (-4.1 %)"
std::string title_of(const Case& c) {
    if (std::isnan(c.amplitude)) {
        const std::string title = c.label + ": no crest";
        return std::isnan(c.long_waves)
                   ? title
                   : title + ", long waves " + io::format_fixed(c.long_waves, 2) + " m/s";
    }
    const std::string title = c.label + ": " + io::format_fixed(c.amplitude, 4) + " m";
    if (std::isnan(c.celerity)) return title;
    return title + ", " + io::format_fixed(c.celerity, 2) + " m/s (" +
           io::format_fixed(c.celerity_error(), 1) + " %)";
}

io::ChartPanel panel(const char* y_label, const char* title, double height) {
    io::ChartPanel made;
    made.title = title;
    made.y_label = y_label;
    made.height = height;
    return made;
}

io::ChartPanel amplitude_panel(const std::vector<Case>& cases) {
    io::ChartPanel made = panel("a / greatest a", "amplitude of the first wave", 260.0);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        made.lines.push_back(
            {.label = title_of(cases[i]), .x = cases[i].time, .y = cases[i].ratio, .color = i});
    }
    return made;
}

io::ChartPanel position_panel(const std::vector<Case>& cases) {
    io::ChartPanel made = panel("distance run (m)", "position of the first wave", 260.0);
    double latest = 0.0, speed = analysis::none;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& c = cases[i];
        made.lines.push_back({.label = title_of(c), .x = c.time, .y = c.run, .color = i});
        if (!c.time.empty()) latest = std::max(latest, c.time.back());
        if (std::isnan(speed)) speed = c.long_wave_celerity;
    }
    io::ChartLine theory{.label = "√(gD) t", .x = {0.0, latest}, .y = {0.0, speed * latest}, .dashed = true};
    theory.faint = true;
    made.lines.push_back(theory);
    return made;
}

// Lines from the gauge at r/D = 2 on, with bands of thin ones.
io::ChartPanel radial_panel(const std::vector<Case>& cases) {
    io::ChartPanel made = panel("a in 3D (m)", "the greatest amplitude spread into 3D, ±50 %", 260.0);
    made.x_label = "r/D";
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Experiment* experiment = experiment_of(cases[i].label);
        const double farthest = experiment ? experiment->farthest : analysis::laboratory_distances.back();
        for (const double share : {1.0, 1.0 - analysis::radial_scatter, 1.0 + analysis::radial_scatter}) {
            io::ChartLine line{.label = {}, .x = {}, .y = {}, .color = i, .dashed = share != 1.0};
            for (double ratio = analysis::laboratory_distances.front(); ratio <= farthest; ratio += 0.5) {
                line.x.push_back(ratio);
                line.y.push_back(share * cases[i].amplitude_3d(ratio));
            }
            made.lines.push_back(line);
        }
        for (const double ratio : analysis::laboratory_distances) {
            if (ratio > farthest) continue;
            made.marks.push_back(
                {.label = {}, .x = ratio, .y = cases[i].amplitude_3d(ratio), .color = i, .note = {}});
        }
    }
    return made;
}

io::ChartPanel speed_panel(const std::vector<Case>& cases) {
    io::ChartPanel made = panel("v_s simulated (m/s)", "the blocks' greatest speed, ±25 % dashed", 260.0);
    made.x_label = "v_s in the laboratory (m/s)";
    constexpr double longest = 1.3;
    for (const double share : {1.0, 0.75, 1.25}) {
        made.lines.push_back({.label = {},
                              .x = {0.0, longest},
                              .y = {0.0, share * longest},
                              .dashed = share != 1.0,
                              .faint = true});
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (const Experiment* experiment = experiment_of(cases[i].label)) {
            made.marks.push_back({.label = {},
                                  .x = experiment->speed,
                                  .y = cases[i].speed,
                                  .color = i,
                                  .note = cases[i].label});
        }
    }
    return made;
}

}  // namespace

std::string draw_cases(const std::vector<Case>& cases, const Provenance& provenance) {
    io::Chart chart{.title = "First waves of the laboratory's icebergs",
                    .x_label = "time since the greatest amplitude (s)",
                    .panels = {},
                    .width = 860.0};
    chart.panels = {amplitude_panel(cases), position_panel(cases), radial_panel(cases), speed_panel(cases)};
    return io::draw_chart(chart, provenance);
}

}  // namespace tidewater::lab
