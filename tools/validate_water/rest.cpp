// Water at rest: what moves, and how far the pressure is from ρ g (D − z).
#include <algorithm>
#include <cmath>

#include "core/types.h"
#include "io/snapshot.h"
#include "io/text.h"
#include "report.h"

namespace tidewater::validation {
namespace {

// Of the frame: pressure in ρgD by layers of a cell from the bed up, and what is off.
struct Profile {
    std::vector<double> height, mean, least, most;  // height in D
    double deviation = 0.0;                         // root mean square, all particles
};

Profile pressure_profile(const io::Snapshot& frame, const scene::Scene& scene) {
    const double depth = scene.water.depth, scale = scene.water.model.density * scene.domain.gravity * depth;
    Profile profile;
    std::vector<double> count;
    double squares = 0.0, all = 0.0;
    for (std::size_t p = 0; p < frame.particle_count(); ++p) {
        const double z = static_cast<double>(frame.points[3 * p + 2]);
        const double pressure = static_cast<double>(frame.pressure[p]) / scale;
        const auto layer = static_cast<std::size_t>(std::max(z / scene.domain.cell_size, 0.0));
        while (profile.mean.size() <= layer) {
            profile.height.push_back((static_cast<double>(count.size()) + 0.5) * scene.domain.cell_size /
                                     depth);
            profile.mean.push_back(0.0);
            profile.least.push_back(analysis::none);
            profile.most.push_back(analysis::none);
            count.push_back(0.0);
        }
        profile.mean[layer] += pressure;
        profile.least[layer] = std::fmin(profile.least[layer], pressure);
        profile.most[layer] = std::fmax(profile.most[layer], pressure);
        count[layer] += 1.0;
        const double off = pressure - std::max(1.0 - z / depth, 0.0);
        squares += off * off;
        all += 1.0;
    }
    for (std::size_t layer = 0; layer < count.size(); ++layer) profile.mean[layer] /= count[layer];
    profile.deviation = std::sqrt(squares / all);
    return profile;
}

double fastest(const io::Snapshot& frame) {
    double squared = 0.0;
    for (std::size_t p = 0; p < frame.particle_count(); ++p) {
        double sum = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double v = static_cast<double>(frame.velocity[3 * p + axis]);
            sum += v * v;
        }
        squared = std::max(squared, sum);
    }
    return std::sqrt(squared);
}

// The mean over all gauges, at each time.
std::vector<double> mean_level(const std::vector<Record>& gauges) {
    std::vector<double> mean(gauges.front().time.size(), 0.0);
    for (const Record& gauge : gauges) {
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += gauge.value[i] / static_cast<double>(gauges.size());
    }
    return mean;
}

std::vector<double> since_start(const std::vector<double>& values, double scale) {
    std::vector<double> change;
    for (const double value : values) change.push_back((value - values.front()) / scale);
    return change;
}

// The bed's pressure over the last fifth of the run, mean of all sensors on it, in ρgD.
double bed_pressure(const Run& run) {
    const auto path = run.folder / "simulate" / "pressures.csv";
    if (!std::filesystem::exists(path)) return analysis::none;
    const double scale = run.scene.water.model.density * run.scene.domain.gravity * run.scene.water.depth;
    double sum = 0.0, count = 0.0;
    for (const Record& record : read_records(path)) {
        if (record.place.z.value_or(1.0) != 0.0) continue;
        for (std::size_t i = 0; i < record.time.size(); ++i) {
            if (record.time[i] < 0.8 * record.time.back()) continue;
            sum += record.value[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count / scale : analysis::none;
}

}  // namespace

Report report_rest(const Run& run) {
    const auto simulated = run.folder / "simulate";
    const double depth = run.scene.water.depth, wave = std::sqrt(run.scene.domain.gravity * depth);
    const auto frames = io::list_snapshots(simulated);
    std::vector<double> times, speeds;
    io::Snapshot last;
    for (const auto& frame : frames) {
        last = io::read_snapshot(frame);
        times.push_back(last.time);
        speeds.push_back(fastest(last) / wave);
    }
    const Profile profile = pressure_profile(last, run.scene);
    const auto gauges = read_records(simulated / "gauges.csv");
    const std::vector<double> level = since_start(mean_level(gauges), 0.01 * depth);
    const io::Table ledger = io::read_table(simulated / "ledger.csv");
    const auto& energy = io::require_column(ledger, "energy", simulated / "ledger.csv");
    const std::vector<double> energy_change = since_start(energy, 1.0);

    Report report{.name = run.name, .findings = {}, .chart = {}};
    const auto add = [&](const char* quantity, const char* unit, double reference, double measured,
                         const char* error_unit) {
        report.findings.push_back({run.name, quantity, unit, reference, measured, error_unit});
    };
    add("pressure on the bed", "ρgD", 1.0, bed_pressure(run), "%");
    add("pressure of all particles: RMS off ρg(D − z)", "ρgD", 0.0, profile.deviation, "");
    add("fastest particle at the end", "√(gD)", 0.0, speeds.back(), "");
    add("fastest particle of all frames", "√(gD)", 0.0, *std::ranges::max_element(speeds), "");
    add("level", "% of D", 0.0, level.back(), "%");
    report.findings.back().error_unit = "";
    add("energy", "J/m", 0.0, energy_change.back(), "");
    add("energy at most above the start", "J/m", 0.0, *std::ranges::max_element(energy_change), "");

    io::Chart& chart = report.chart;
    chart = {.title = run.scene.title, .x_label = "time (s)", .panels = {}, .panel_height = 170.0};
    chart.panels.resize(4);
    chart.panels[0].y_label = "level (% of D)";
    chart.panels[0].lines = {{.label = "simulated", .x = gauges.front().time, .y = level}};
    chart.panels[1].y_label = "max |v|/√(gD)";
    chart.panels[1].lines = {
        {.label = "simulated", .x = times, .y = speeds, .dots = true},
        {.label = "aim", .x = {0.0, times.back()}, .y = {3e-3, 3e-3}, .color = 1, .dashed = true}};
    chart.panels[2].y_label = "energy change (J/m)";
    chart.panels[2].lines = {{.label = "simulated",
                              .x = io::require_column(ledger, "time", simulated / "ledger.csv"),
                              .y = energy_change}};
    io::ChartPanel& pressure = chart.panels[3];
    pressure.title = "at the end, layers of a cell: mean, least and most";
    pressure.x_label = "z/D";
    pressure.y_label = "p/ρgD";
    pressure.height = 300.0;
    pressure.lines = {{.label = "ρg(D − z)", .x = {0.0, 1.0}, .y = {1.0, 0.0}, .color = 1, .dashed = true},
                      {.label = "", .x = profile.height, .y = profile.least, .faint = true},
                      {.label = "", .x = profile.height, .y = profile.most, .faint = true},
                      {.label = "simulated", .x = profile.height, .y = profile.mean, .dots = true}};
    return report;
}

}  // namespace tidewater::validation
