#include "wave_charts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "io/chart.h"
#include "io/heat_map.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

// r^-n through the fit's amplitude in the middle of the logarithmic distances.
io::ChartLine power_line(const WaveDecay& decay, double exponent, const std::string& label) {
    const double near = decay.points.front().distance / decay.depth,
                 far = decay.points.back().distance / decay.depth, middle = std::sqrt(near * far);
    const double amplitude = decay.fit.amplitude * std::pow(middle, -decay.fit.exponent);
    io::ChartLine line{.label = label, .x = {near, far}, .y = {}};
    for (const double x : line.x) line.y.push_back(amplitude * std::pow(x / middle, -exponent));
    return line;
}

// Rows at even times, each of the frame nearest to it.
struct EvenFrames {
    double start = 0.0, step = 1.0;  // s
    std::vector<std::size_t> frame;
};

EvenFrames even_frames(const std::vector<analysis::SurfaceProfile>& profiles) {
    EvenFrames even{.start = profiles.front().time, .frame = {}};
    const double duration = profiles.back().time - even.start;
    if (profiles.size() > 1) even.step = duration / static_cast<double>(profiles.size() - 1);
    std::size_t nearest = 0;
    for (std::size_t row = 0; row < profiles.size(); ++row) {
        const double time = even.start + static_cast<double>(row) * even.step;
        while (nearest + 1 < profiles.size() &&
               std::abs(profiles[nearest + 1].time - time) <= std::abs(profiles[nearest].time - time))
            ++nearest;
        even.frame.push_back(nearest);
    }
    return even;
}

// Through (x, time), both ways as far as there is water in the tank at rest.
io::ChartLine long_wave_line(const SurfaceProfiles& profiles, double x, double time, bool to_the_right,
                             const scene::Scene& scene) {
    const std::vector<double>& places = profiles.x;
    const auto slowness = [&](std::size_t i) {
        const double depth = scene.water.depth - static_cast<double>(profiles.bed[i]);
        return depth > 0.0 ? 1.0 / std::sqrt(scene.domain.gravity * depth) : analysis::none;
    };
    std::vector<double> passed{0.0};  // s, from the first place to each
    for (std::size_t i = 1; i < places.size(); ++i)
        passed.push_back(passed.back() + 0.5 * (slowness(i - 1) + slowness(i)) * (places[i] - places[i - 1]));
    const auto at = static_cast<std::size_t>(std::ranges::lower_bound(places, x) - places.begin());
    io::ChartLine line{
        .label = "√(gD) through the leading crest", .x = {}, .y = {}, .color = 0, .dashed = true};
    if (at == places.size()) return line;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double t = time + (to_the_right ? 1.0 : -1.0) * (passed[i] - passed[at]);
        if (!(t >= profiles.of_time.front().time) || t > profiles.of_time.back().time) continue;
        line.x.push_back(places[i]);
        line.y.push_back(t);
    }
    return line;
}

// The first gauge on the path that saw a crest, as (x, time).
io::ChartLine theory_line(const Surfaces& surfaces, const Waves& waves, const WavePath& path,
                          const scene::Scene& scene) {
    const analysis::GaugeWave* first = nullptr;
    for (const analysis::GaugeWave& gauge : waves.gauges) {
        if (std::isnan(gauge.crest_time) || (gauge.x > path.source) != path.to_the_right()) continue;
        if (!first || std::abs(gauge.x - path.source) < std::abs(first->x - path.source)) first = &gauge;
    }
    if (!first) return {};
    return long_wave_line(surfaces.profiles, first->x, first->crest_time, path.to_the_right(), scene);
}

std::string place_title(const GaugeRecord& record) {
    std::string title = "x = " + io::format_number(*record.place.x) + " m";
    if (record.place.y) title += ", y = " + io::format_number(*record.place.y) + " m";
    return title + (record.source == "run" ? "" : ", from snapshots");
}

}  // namespace

std::string spectra_chart(const Waves& waves, const StageContext& context) {
    io::Chart chart{.title = context.scene.title, .x_label = "frequency (Hz)", .panels = {}};
    for (std::size_t i = 0; i < waves.records.size(); ++i) {
        const GaugeStatistics& statistics = waves.statistics[i];
        const analysis::Spectrum& spectrum = statistics.spectrum;
        if (spectrum.frequency.empty()) continue;
        const double highest = highest_frequency(statistics.depth, context.scene);
        io::ChartLine line{.label = {}, .x = {}, .y = {}};
        for (std::size_t k = 0; k < spectrum.frequency.size() && spectrum.frequency[k] <= highest; ++k) {
            line.x.push_back(spectrum.frequency[k]);
            line.y.push_back(spectrum.density[k]);
        }
        const double period = spectrum.peak_period();
        const std::string height = "H_m0 = " + io::format_fixed(spectrum.significant_height(), 4) + " m";
        io::ChartPanel panel{.title = place_title(waves.records[i]) + ": " +
                                      (spectrum.peak_is_resolved() ? height : spectrum.doubt),
                             .y_label = "E (m²/Hz)",
                             .lines = {line},
                             .marks = {}};
        if (!std::isnan(period)) {
            panel.marks.push_back({.label = "peak",
                                   .shape = io::MarkShape::rule,
                                   .x = 1.0 / period,
                                   .note = "T_p = " + io::format_fixed(period, 2) + " s"});
        }
        chart.panels.push_back(panel);
    }
    return io::draw_chart(chart, context.provenance);
}

std::string decay_chart(const WaveDecay& decay, const StageContext& context) {
    io::ChartPanel panel{.title = {}, .y_label = "leading crest (m)", .lines = {}, .marks = {}};
    panel.log_x = panel.log_y = true;
    for (const WaveDecay::Point& point : decay.points)
        panel.marks.push_back(
            {.label = "gauges", .x = point.distance / decay.depth, .y = point.crest, .note = {}});
    if (!std::isnan(decay.fit.exponent)) {
        std::string label = "fit, n = " + io::format_fixed(decay.fit.exponent, 2);
        if (!std::isnan(decay.fit.exponent_low)) {
            label += " (95 %: " + io::format_fixed(decay.fit.exponent_low, 2) + " to " +
                     io::format_fixed(decay.fit.exponent_high, 2) + ")";
        }
        panel.lines.push_back(power_line(decay, decay.fit.exponent, label));
        panel.lines.push_back(power_line(decay, 1.0 / 3.0, "n = 1/3, a linear wave's front in a flume"));
        panel.lines.push_back(power_line(decay, 0.5, "n = 1/2, spread over a circle"));
        panel.lines.push_back(power_line(decay, 5.0 / 6.0, "n = 5/6, 2D→3D in the laboratory"));
        for (std::size_t i = 1; i < panel.lines.size(); ++i) {
            panel.lines[i].color = i + 1;
            panel.lines[i].dashed = true;
        }
        if (!decay.fit.trustworthy()) panel.title = "not trustworthy: " + decay.fit.doubt;
    }
    return io::draw_chart({.title = context.scene.title,
                           .x_label = "distance r/D, crest ~ r⁻ⁿ",
                           .panels = {panel},
                           .width = 760.0,
                           .panel_height = 360.0},
                          context.provenance);
}

std::string space_time_chart(const Surfaces& surfaces, const Waves& waves, const WavePath& path,
                             const StageContext& context) {
    const SurfaceProfiles& profiles = surfaces.profiles;
    const EvenFrames even = even_frames(profiles.of_time);
    const double cell = context.scene.domain.cell_size;
    io::HeatMap map{.title = context.scene.title,
                    .x_label = "x (m)",
                    .y_label = "time (s)",
                    .value_label = "η (m)",
                    .left = profiles.x.front() - 0.5 * cell,
                    .right = profiles.x.back() + 0.5 * cell,
                    .bottom = even.start - 0.5 * even.step,
                    .top = even.start + (static_cast<double>(even.frame.size()) - 0.5) * even.step,
                    .columns = profiles.x.size(),
                    .rows = even.frame.size()};
    for (const std::size_t frame : even.frame) {
        const std::vector<double>& eta = profiles.of_time[frame].elevation;
        map.values.insert(map.values.end(), eta.begin(), eta.end());
    }
    const io::ChartLine line = theory_line(surfaces, waves, path, context.scene);
    if (!line.x.empty()) map.lines.push_back(line);
    return io::draw_heat_map(map, context.provenance);
}

std::string run_up_chart(const Surfaces& surfaces, const StageContext& context) {
    io::ChartLine shore{.label = "waterline on the shore", .x = {}, .y = {}},
        wall{.label = "elevation at the wall", .x = {}, .y = {}, .color = 1};
    for (const FarEnd& end : surfaces.far_end) {
        io::ChartLine& line = end.waterline.at_wall ? wall : shore;
        line.x.push_back(end.time);
        line.y.push_back(end.waterline.height);
    }
    io::ChartPanel panel{.title = {}, .y_label = "height (m)", .lines = {}, .marks = {}};
    for (const io::ChartLine& line : {shore, wall}) {
        if (!line.x.empty()) panel.lines.push_back(line);
    }
    return io::draw_chart(
        {.title = context.scene.title, .x_label = "time (s)", .panels = {panel}, .panel_height = 240.0},
        context.provenance);
}

io::SpaceTime space_time_record(const Surfaces& surfaces, const StageContext& context) {
    io::SpaceTime record{.title = context.scene.title, .time = {}, .x = surfaces.profiles.x, .elevation = {}};
    for (const analysis::SurfaceProfile& profile : surfaces.profiles.of_time) {
        record.time.push_back(profile.time);
        for (const double eta : profile.elevation) record.elevation.push_back(static_cast<float>(eta));
    }
    return record;
}

}  // namespace tidewater::postprocess
