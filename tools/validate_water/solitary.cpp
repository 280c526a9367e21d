// A solitary wave: its celerity, and what it loses.
#include <algorithm>
#include <cmath>

#include "analysis/wave_theory.h"
#include "io/text.h"
#include "report.h"

namespace tidewater::validation {
namespace {

constexpr double smoothing = 0.05;  // deviation in √(D/g), for the crests

struct Crest {
    double x, time, height;
};

std::vector<Crest> find_crests(const std::vector<Record>& gauges, const scene::Scene& scene) {
    const double deviation = smoothing * std::sqrt(scene.water.depth / scene.domain.gravity);
    std::vector<Crest> crests;
    for (const Record& gauge : gauges) {
        const auto smooth = analysis::smooth(gauge.time, gauge.value, deviation);
        const auto peak = static_cast<std::size_t>(std::ranges::max_element(smooth) - smooth.begin());
        const auto crest = analysis::fit_crest(gauge.time, smooth, peak, 0.1 * scene.wave.height);
        if (peak > 0 && peak + 1 < smooth.size()) crests.push_back({*gauge.place.x, crest.time, crest.value});
    }
    std::ranges::sort(crests, {}, &Crest::x);
    return crests;
}

// 1 / slope of the line of least squares t = t0 + x/c.
double celerity(const std::vector<Crest>& crests) {
    double x = 0.0, t = 0.0, xx = 0.0, xt = 0.0;
    const auto count = static_cast<double>(crests.size());
    for (const Crest& crest : crests) x += crest.x / count, t += crest.time / count;
    for (const Crest& crest : crests) {
        xx += (crest.x - x) * (crest.x - x);
        xt += (crest.x - x) * (crest.time - t);
    }
    return xx / xt;
}

io::ChartPanel gauge_panel(const Record& gauge, const analysis::InitialWave& wave) {
    io::ChartPanel panel;
    panel.title = "x − x0 = " + io::format_fixed((*gauge.place.x - wave.center) / wave.depth, 1) + " D";
    panel.y_label = "η/a";
    io::ChartLine theory{
        .label = "theory, unchanged shape", .x = gauge.time, .y = {}, .color = 1, .dashed = true};
    io::ChartLine simulated{.label = "simulated", .x = gauge.time, .y = gauge.value};
    const double c = analysis::solitary_celerity(wave);
    for (const double t : gauge.time)
        theory.y.push_back(analysis::elevation(wave, *gauge.place.x - c * t) / wave.height);
    for (double& value : simulated.y) value /= wave.height;
    panel.lines = {theory, simulated};
    return panel;
}

}  // namespace

Report report_solitary(const Run& run) {
    const analysis::InitialWave wave = initial_wave(run.scene);
    const auto gauges = read_records(run.folder / "simulate" / "gauges.csv");
    const std::vector<Crest> crests = find_crests(gauges, run.scene);
    Report report{.name = run.name, .findings = {}, .chart = {}};
    double mean = 0.0;
    for (const Crest& crest : crests) mean += crest.height / static_cast<double>(crests.size());
    const double speed = crests.size() > 1 ? celerity(crests) : analysis::none;
    const auto reference = [&](double height) { return std::sqrt(wave.gravity * (wave.depth + height)); };
    const Crest last = crests.empty() ? Crest{wave.center, 0.0, analysis::none} : crests.back();
    report.findings = {
        {run.name, "celerity, √(g(D + a))", "m/s", reference(wave.height), speed, "%"},
        {run.name, "celerity, of the mean height on the way", "m/s", reference(mean), speed, "%"},
        {run.name, "height after " + io::format_fixed((last.x - wave.center) / wave.depth, 1) + " D", "a",
         1.0, last.height / wave.height, "%"}};

    io::Chart& chart = report.chart;
    chart = {.title = run.scene.title, .x_label = "time (s)", .panels = {}, .panel_height = 150.0};
    for (const std::size_t g : {gauges.size() / 4, gauges.size() / 2, gauges.size() - 1})
        chart.panels.push_back(gauge_panel(gauges[g], wave));
    io::ChartPanel heights;
    heights.x_label = "(x − x0)/D";
    heights.y_label = "crest/a";
    heights.height = 220.0;
    io::ChartLine line{.label = "simulated", .x = {}, .y = {}, .dots = true};
    for (const Crest& crest : crests) {
        line.x.push_back((crest.x - wave.center) / wave.depth);
        line.y.push_back(crest.height / wave.height);
    }
    heights.lines = {{.label = "theory, unchanged shape",
                      .x = {0.0, (last.x - wave.center) / wave.depth},
                      .y = {1.0, 1.0},
                      .color = 1,
                      .dashed = true},
                     line};
    chart.panels.push_back(heights);
    return report;
}

}  // namespace tidewater::validation
