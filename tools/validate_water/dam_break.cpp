// Dam breaks: the front on a dry bed, and the pressure on the wall that it strikes.
#include <algorithm>
#include <cmath>

#include "analysis/front.h"
#include "core/error.h"
#include "io/snapshot.h"
#include "io/text.h"
#include "report.h"

namespace tidewater::validation {
namespace {

struct Series {
    std::vector<double> x, y;
};

Series read_series(const std::filesystem::path& path, const char* x, const char* y) {
    const io::Table table = io::read_table(path);
    return {io::require_column(table, x, path), io::require_column(table, y, path)};
}

// Linear between samples of rising x; the ends beyond.
double at(const Series& series, double x) {
    const auto next = std::ranges::lower_bound(series.x, x);
    if (next == series.x.begin()) return series.y.front();
    if (next == series.x.end()) return series.y.back();
    const auto i = static_cast<std::size_t>(next - series.x.begin());
    const double share = (x - series.x[i - 1]) / (series.x[i] - series.x[i - 1]);
    return series.y[i - 1] + share * (series.y[i] - series.y[i - 1]);
}

// When y first passes the level. Published series stand still in x where they rise.
double passage(const Series& series, double level) {
    for (std::size_t i = 1; i < series.x.size(); ++i) {
        if (!(series.y[i] >= level)) continue;
        const double share = (level - series.y[i - 1]) / (series.y[i] - series.y[i - 1]);
        return series.x[i - 1] + std::clamp(share, 0.0, 1.0) * (series.x[i] - series.x[i - 1]);
    }
    return analysis::none;
}

// z/a over t √(2g/a), from the frames.
Series simulated_front(const Run& run) {
    const scene::Scene& scene = run.scene;
    const double width = scene.water.length, unit = std::sqrt(2.0 * scene.domain.gravity / width);
    const double spacing = scene.domain.cell_size / scene.particles.per_axis;
    Series front;
    for (const auto& path : io::list_snapshots(run.folder / "simulate")) {
        const io::Snapshot frame = io::read_snapshot(path);
        const double x = analysis::water_front(frame.points, frame.material, 2.0 * scene.domain.cell_size);
        front.x.push_back(frame.time * unit);
        front.y.push_back((x + 0.5 * spacing) / width);
        if (x > scene.domain.size.front() - scene.domain.cell_size) break;  // at the far wall
    }
    return front;
}

// Largest and mean square difference over the published times that the run reaches, in shares of the
// published.
struct Difference {
    double greatest = 0.0, square = 0.0;
};

Difference difference(const Series& simulated, const Series& published, double shift) {
    Difference all;
    for (std::size_t i = 0; i < published.x.size(); ++i) {
        if (published.x[i] + shift > simulated.x.back()) break;
        const double off = at(simulated, published.x[i] + shift) / published.y[i] - 1.0;
        if (std::abs(off) > std::abs(all.greatest)) all.greatest = off;
        all.square += off * off;
    }
    return all;
}

// What has to be added to published times: the best in the mean square. Negative, since the gate takes its
// time.
double best_shift(const Series& simulated, const Series& published) {
    double best = 0.0, least = difference(simulated, published, 0.0).square;
    for (int n = -200; n <= 200; ++n) {
        const double square = difference(simulated, published, 0.005 * n).square;
        if (square < least) least = square, best = 0.005 * n;
    }
    return best;
}

// Least squares' slope of the series from x = from to x = to.
double slope(const Series& series, double from, double to) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (series.x[i] < from || series.x[i] > to) continue;
        n += 1.0, x += series.x[i], y += series.y[i];
        xx += series.x[i] * series.x[i], xy += series.x[i] * series.y[i];
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

Series shifted(Series series, double shift) {
    for (double& x : series.x) x += shift;
    return series;
}

// The published series of a sensor at this height, m; an empty name if there is none.
std::string sensor_file(double z) {
    const struct {
        double z;
        const char* name;
    } sensors[] = {{0.003, "sensor1_z3mm"}, {0.03, "sensor3_z30mm"}, {0.08, "sensor4_z80mm"}};
    for (const auto& sensor : sensors) {
        if (std::abs(sensor.z - z) < 5e-4)
            return "dam_break_pressure_lobovsky_2014_H300_" + std::string(sensor.name) + ".csv";
    }
    return {};
}

}  // namespace

Report report_front(const Run& run, const std::filesystem::path& data) {
    const scene::Scene& scene = run.scene;
    const double width = scene.water.length, ratio = scene.water.depth / width;
    if (std::abs(ratio - 2.0) > 0.01)
        throw InputError(run.folder.string() + ": a column of n² = " + io::format_fixed(ratio, 2) +
                         ", and the published series are of n² = 2; change water.length");
    const bool large = std::abs(width - 0.05715) < std::abs(width - 0.028575);
    const Series published = read_series(data / ("dam_break_front_martin_moyce_1952_n2_2_a" +
                                                 std::string(large ? "2.25" : "1.125") + "in.csv"),
                                         "t_sqrt_2g_over_a", "z_over_a");
    const Series simulated = simulated_front(run);
    const double shift = best_shift(simulated, published);
    const double middle = 4.0, end = std::min(published.x.back(), simulated.x.back());
    Report report{.name = run.name, .findings = {}, .chart = {}};
    report.findings = {{run.name, "how much later their clock shows it", "√(a/2g)", 0.0, -shift, ""},
                       {run.name, "front, greatest difference after the shift", "%", 0.0,
                        100.0 * difference(simulated, published, shift).greatest, ""},
                       {run.name, "front at the last mark, after the shift", "a", published.y.back(),
                        at(simulated, published.x.back() + shift), "%"},
                       {run.name, "front, greatest difference as it is", "%", 0.0,
                        100.0 * difference(simulated, published, 0.0).greatest, ""},
                       {run.name, "speed of the front from t = 4 on", "√(2ga)", slope(published, middle, end),
                        slope(simulated, middle, end), "%"}};
    io::ChartPanel panel;
    panel.y_label = "z/a";
    const Series moved = shifted(published, shift);
    panel.lines = {{.label = "simulated", .x = simulated.x, .y = simulated.y}};
    for (std::size_t i = 0; i < published.x.size(); ++i) {
        panel.marks.push_back({.label = "Martin & Moyce 1952",
                               .shape = io::MarkShape::ring,
                               .x = published.x[i],
                               .y = published.y[i],
                               .color = 2,
                               .note = {}});
        panel.marks.push_back({.label = "the same, " + io::format_fixed(-shift, 2) + " earlier",
                               .x = moved.x[i],
                               .y = moved.y[i],
                               .color = 1,
                               .note = {}});
    }
    report.chart = {.title = scene.title, .x_label = "t √(2g/a)", .panels = {panel}, .panel_height = 420.0};
    return report;
}

Report report_pressure(const Run& run, const std::filesystem::path& data) {
    const scene::Scene& scene = run.scene;
    constexpr double onset = 0.1;       // p/ρgH at which the water has arrived
    constexpr double smoothing = 0.02;  // deviation in √(H/g), about 3 ms
    const double depth = scene.water.depth, unit = std::sqrt(scene.domain.gravity / depth);
    const double scale = scene.water.model.density * scene.domain.gravity * depth;
    Report report{.name = run.name, .findings = {}, .chart = {}};
    report.chart = {.title = scene.title, .x_label = "t √(g/H)", .panels = {}, .panel_height = 240.0};
    for (const Record& record : read_records(run.folder / "simulate" / "pressures.csv")) {
        Series raw{record.time, record.value}, smooth = raw;
        smooth.y = analysis::smooth(record.time, record.value, smoothing / unit);
        for (Series* series : {&raw, &smooth}) {
            for (double& x : series->x) x *= unit;
            for (double& y : series->y) y /= scale;
        }
        const std::string place = io::place_name(record.place);
        io::ChartPanel panel;
        panel.title = place;
        panel.y_label = "p/ρgH";
        panel.lines = {{.label = "simulated", .x = raw.x, .y = raw.y, .faint = true},
                       {.label = "simulated, smoothed", .x = smooth.x, .y = smooth.y}};
        if (const std::string file = sensor_file(record.place.z.value_or(-1.0)); !file.empty()) {
            const Series published = read_series(data / file, "t_sqrt_g_over_H", "p_over_rho_g_H");
            panel.lines.push_back(
                {.label = "Lobovský et al. 2014", .x = published.x, .y = published.y, .color = 1});
            const auto peak = [](const Series& series) { return *std::ranges::max_element(series.y); };
            const auto add = [&](const std::string& quantity, const char* of, double reference,
                                 double measured) {
                report.findings.push_back({run.name, place + ": " + quantity, of, reference, measured, "%"});
            };
            add("arrival", "√(H/g)", passage(published, onset), passage(smooth, onset));
            add("peak", "ρgH", peak(published), peak(smooth));
            for (const double time : {3.17, 4.08, 5.0})
                add("at t = " + io::format_fixed(time, 2), "ρgH", at(published, time), at(smooth, time));
        }
        report.chart.panels.push_back(panel);
    }
    return report;
}

}  // namespace tidewater::validation
