// Standing waves: period and damping, alone and over k.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/oscillation.h"
#include "io/text.h"
#include "report.h"

namespace tidewater::validation {
namespace {

struct Standing {
    double wavenumber = 0.0, theory = 0.0;  // k, 1/m; ω of linear theory, rad/s
    std::vector<double> time, amplitude;    // of cos(kx), m
    analysis::Oscillation fit;

    double period() const { return 2.0 * std::numbers::pi / fit.frequency; }
    double viscosity() const { return fit.decay / (2.0 * wavenumber * wavenumber); }  // m²/s
};

// The least squares' amplitude of cos(kx), beside a constant, at each time.
std::vector<double> mode_amplitude(const std::vector<Record>& gauges, double wavenumber) {
    std::vector<double> shape;
    double mean = 0.0, squares = 0.0;
    for (const Record& gauge : gauges) shape.push_back(std::cos(wavenumber * *gauge.place.x));
    for (const double s : shape) mean += s / static_cast<double>(shape.size());
    for (double& s : shape) s -= mean;
    for (const double s : shape) squares += s * s;
    std::vector<double> amplitude(gauges.front().time.size(), 0.0);
    for (std::size_t g = 0; g < gauges.size(); ++g) {
        for (std::size_t i = 0; i < amplitude.size(); ++i)
            amplitude[i] += shape[g] / squares * gauges[g].value[i];
    }
    return amplitude;
}

Standing look_at(const Run& run) {
    const auto gauges = read_records(run.folder / "simulate" / "gauges.csv");
    Standing wave;
    wave.wavenumber = 2.0 * std::numbers::pi / run.scene.wave.length;
    wave.theory =
        analysis::angular_frequency(wave.wavenumber, run.scene.water.depth, run.scene.domain.gravity);
    wave.time = gauges.front().time;
    wave.amplitude = mode_amplitude(gauges, wave.wavenumber);
    wave.fit = analysis::fit_oscillation(wave.time, wave.amplitude, wave.theory);
    return wave;
}

io::ChartLine theory_curve(double from, double to, const scene::Scene& scene) {
    io::ChartLine line{.label = "√(gk tanh kD)", .x = {}, .y = {}, .color = 1};
    const double depth = scene.water.depth, gravity = scene.domain.gravity;
    for (int i = 0; i <= 200; ++i) {
        const double kd = from + (to - from) * i / 200.0;
        line.x.push_back(kd);
        line.y.push_back(analysis::angular_frequency(kd / depth, depth, gravity) *
                         std::sqrt(depth / gravity));
    }
    return line;
}

}  // namespace

Report report_standing(const Run& run) {
    const Standing wave = look_at(run);
    const double height = run.scene.wave.height, end = wave.time.back();
    Report report{.name = run.name, .findings = {}, .chart = {}};
    report.findings = {
        {run.name, "period", "s", 2.0 * std::numbers::pi / wave.theory, wave.period(), "%"},
        {run.name, "viscosity that would damp it so", "m²/s", 0.0, wave.viscosity(), ""},
        {run.name, "amplitude left at the end", "a", 1.0, wave.fit.envelope(end) / height, "%"},
        {run.name, "off the fitted oscillation, RMS", "a", 0.0, wave.fit.misfit / height, ""}};
    io::ChartPanel panel;
    panel.y_label = "amplitude of cos(kx) over a";
    io::ChartLine simulated{.label = "simulated", .x = wave.time, .y = wave.amplitude};
    io::ChartLine theory{
        .label = "a cos(ωt), linear theory", .x = wave.time, .y = {}, .color = 1, .dashed = true};
    io::ChartLine envelope{.label = "fitted envelope", .x = wave.time, .y = {}, .faint = true};
    for (double& value : simulated.y) value /= height;
    for (const double t : wave.time) {
        theory.y.push_back(std::cos(wave.theory * t));
        envelope.y.push_back(wave.fit.envelope(t) / height);
    }
    panel.lines = {theory, envelope, simulated};
    report.chart = {
        .title = run.scene.title, .x_label = "time (s)", .panels = {panel}, .panel_height = 300.0};
    return report;
}

Report report_dispersion(const std::vector<Run>& runs) {
    std::vector<Standing> waves;
    for (const Run& run : runs) waves.push_back(look_at(run));
    std::ranges::sort(waves, {}, &Standing::wavenumber);
    const scene::Scene& scene = runs.front().scene;
    const double depth = scene.water.depth, unit = std::sqrt(depth / scene.domain.gravity);
    io::ChartLine frequency{.label = "simulated", .x = {}, .y = {}, .dots = true};
    io::ChartLine error = frequency, viscosity = frequency;
    double worst = 0.0;
    for (const Standing& wave : waves) {
        for (io::ChartLine* line : {&frequency, &error, &viscosity})
            line->x.push_back(wave.wavenumber * depth);
        const double off = wave.fit.frequency / wave.theory - 1.0;
        if (!(std::abs(off) <= std::abs(worst))) worst = off;
        frequency.y.push_back(wave.fit.frequency * unit);
        error.y.push_back(100.0 * off);
        viscosity.y.push_back(wave.viscosity());
    }
    Report report{.name = "dispersion", .findings = {}, .chart = {}};
    report.findings = {
        {"dispersion",
         "greatest difference of ω, k D up to " + io::format_fixed(waves.back().wavenumber * depth, 1), "%",
         0.0, 100.0 * worst, ""}};
    const io::ChartLine zero{
        .label = "", .x = {frequency.x.front(), frequency.x.back()}, .y = {0.0, 0.0}, .color = 1};
    report.chart = {
        .title = "Standing waves, dispersion and damping",
        .x_label = "kD",
        .panels =
            {{.title = {},
              .y_label = "ω √(D/g)",
              .lines = {theory_curve(frequency.x.front(), frequency.x.back(), scene), frequency},
              .marks = {}},
             {.title = {}, .y_label = "error of ω (%)", .lines = {zero, error}, .marks = {}},
             {.title = {}, .y_label = "ν of the damping (m²/s)", .lines = {zero, viscosity}, .marks = {}}},
        .panel_height = 200.0};
    return report;
}

}  // namespace tidewater::validation
