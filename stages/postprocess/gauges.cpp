#include "gauges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "analysis/surface.h"
#include "common/tank.h"
#include "core/error.h"
#include "io/table.h"
#include "io/text.h"
#include "io/wave_records_nc.h"
#include "wave_source.h"

namespace tidewater::postprocess {
namespace {

// In cells; analysis/surface.h: particle noise stays below.
constexpr double smallest_amplitude = 0.25;

analysis::WaveSettings wave_settings(const scene::Scene& scene, double x) {
    return {.depth = scene.water.depth,
            .gravity = scene.domain.gravity,
            .far_wall = is_left_of_block(scene, x) ? 0.0 : scene.domain.size.front(),
            .arrival_threshold = scene.postprocess.arrival_threshold,
            .smallest_amplitude = smallest_amplitude * scene.domain.cell_size};
}

double error_percent(double value, double reference) { return 100.0 * (value / reference - 1.0); }

std::vector<std::string> row(const Waves& waves, const io::NamedPlace& place, const std::string& source,
                             const std::vector<double>& seen, const analysis::Celerity& celerity,
                             const GaugeStatistics& statistics) {
    std::vector<std::string> cells{io::format_number(place.x.value_or(analysis::none)),
                                   io::format_number(place.y.value_or(analysis::none)), source};
    for (const double value : seen) cells.push_back(io::format_number(value));
    const double reference = waves.long_wave_celerity;
    for (const double value :
         {celerity.from_crests, reference, error_percent(celerity.from_crests, reference),
          celerity.from_arrivals, error_percent(celerity.from_arrivals, reference)}) {
        cells.push_back(io::format_number(value));
    }
    const analysis::WaveStatistics& s = statistics.waves;
    const analysis::Spectrum& spectrum = statistics.spectrum;
    for (const double value : {statistics.depth, static_cast<double>(s.waves), s.significant_height,
                               s.greatest_height, s.mean_height, s.mean_period, s.significant_period,
                               spectrum.significant_height(), spectrum.peak_period(), spectrum.mean_period(),
                               spectrum.zero_crossing_period(), statistics.energy_flux, statistics.energy})
        cells.push_back(io::format_number(value));
    cells.push_back(statistics.doubt);
    return cells;
}

// A column of the printed table; "-" where there is no number.
std::string cell(double value, int width, int decimals) {
    const std::string text = std::isnan(value) ? "-" : io::format_fixed(value, decimals);
    return std::string(static_cast<std::size_t>(std::max(width - static_cast<int>(text.size()), 0)), ' ') +
           text;
}

std::string describe_speed(double speed, double reference) {
    if (std::isnan(speed)) return "celerity: too few gauges saw the wave\n";
    const double error = error_percent(speed, reference);
    return "celerity of the leading crest: " + io::format_fixed(speed, 3) + " m/s, " +
           (error < 0.0 ? "" : "+") + io::format_fixed(error, 1) +
           " % of sqrt(g D) = " + io::format_fixed(reference, 3) + " m/s\n";
}

}  // namespace

std::vector<GaugeRecord> read_run_gauges(const std::filesystem::path& path) {
    const io::Table table = io::read_table(path);
    const auto& time = io::require_column(table, "time", path);
    std::vector<GaugeRecord> records;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (table.columns[c] == "time") continue;
        const auto place = io::parse_place(table.columns[c]);
        if (!place) {
            throw InputError(path.string() + ": column \"" + table.columns[c] +
                             "\" names no place; run tidewater-simulate again");
        }
        records.push_back({*place, "run", time, table.values[c]});
    }
    return records;
}

FrameProduct gauges_product(const StageContext& context, const Ground& ground) {
    const scene::Scene& scene = context.scene;
    const auto places = gauge_places(scene.postprocess.gauges, scene, ground);
    std::vector<std::string> columns{"time"};
    for (const auto& gauge : scene.postprocess.gauges) columns.push_back(io::place_name(gauge_name(gauge)));
    constexpr std::array<std::string_view, 1> keys{"postprocess.gauges"};
    return {.name = "gauges",
            .settings = scene::values_of(scene, keys),
            .files =
                [any = !places.empty()](std::size_t frame) {
                    return any ? std::vector{frame_file("gauges", frame)} : std::vector<std::string>{};
                },
            .make =
                [=, tank = make_tank(scene), folder = context.folder](
                    std::size_t frame, const io::Snapshot& snapshot, const Provenance& provenance) {
                    std::vector<double> row = analysis::surface_elevation(
                        {snapshot.points, snapshot.volume, snapshot.material}, tank, places);
                    row.insert(row.begin(), snapshot.time);
                    io::TableWriter table(folder / frame_file("gauges", frame), provenance, columns);
                    table.append(row);
                    table.finish();
                },
            .follows = false};
}

std::vector<GaugeRecord> gather_gauges(const StageContext& context, const Frames& frames) {
    std::vector<GaugeRecord> records;
    for (const auto& gauge : context.scene.postprocess.gauges)
        records.push_back({gauge_name(gauge), "snapshots", frames.times, {}});
    for (std::size_t frame = 0; frame < frames.times.size() && !records.empty(); ++frame) {
        const auto path = context.folder / frame_file("gauges", frame);
        const io::Table table = io::read_table(path);
        for (GaugeRecord& record : records)
            record.elevation.push_back(io::require_column(table, io::place_name(record.place), path).at(0));
    }
    return records;
}

void write_gauges(const std::filesystem::path& path, const std::vector<GaugeRecord>& records,
                  const Provenance& provenance) {
    std::vector<std::string> columns{"time"};
    for (const GaugeRecord& record : records) columns.push_back(io::place_name(record.place));
    io::TableWriter table(path, provenance, columns);
    const std::size_t rows = records.empty() ? 0 : records.front().time.size();
    for (std::size_t r = 0; r < rows; ++r) {
        std::vector<double> values{records.front().time[r]};
        for (const GaugeRecord& record : records) values.push_back(record.elevation[r]);
        table.append(values);
    }
    table.finish();
}

void write_gauges_nc(const std::filesystem::path& folder, const std::vector<GaugeRecord>& records,
                     const scene::Scene& scene, const Provenance& provenance) {
    const double middle = 0.5 * make_tank(scene).size[1];
    io::GaugeRecords run{.title = scene.title, .time = {}, .stations = {}}, snapshots = run;
    for (const GaugeRecord& record : records) {
        io::GaugeRecords& file = record.source == "run" ? run : snapshots;
        file.time = record.time;
        file.stations.push_back({io::place_name(record.place), *record.place.x,
                                 record.place.y.value_or(middle), record.elevation});
    }
    io::write_gauges_nc(folder / "gauges.nc", run.stations.empty() ? snapshots : run, provenance);
    if (!run.stations.empty()) io::write_gauges_nc(folder / "gauges_snapshots.nc", snapshots, provenance);
}

Waves analyse(std::vector<GaugeRecord> records, const scene::Scene& scene, const Ground& ground) {
    Waves waves;
    waves.records = std::move(records);
    std::ranges::stable_sort(waves.records, {}, [](const GaugeRecord& record) {
        return std::pair(record.place.y.value_or(-1.0), record.place.x);
    });
    const bool waves_run = scene.has("water") && scene.domain.gravity > 0.0;
    for (const GaugeRecord& record : waves.records) {
        const double x = *record.place.x;
        waves.gauges.emplace_back().x = x;
        waves.statistics.emplace_back();
        if (!waves_run) continue;
        waves.gauges.back() =
            analysis::analyse_gauge(x, record.time, record.elevation, wave_settings(scene, x));
        const double y = record.place.y.value_or(0.5 * make_tank(scene).size[1]);
        waves.statistics.back() =
            gauge_statistics(record, waves.gauges.back(), scene.water.depth - ground.height(x, y), scene);
    }
    waves.to_next = analysis::celerity_between(waves.gauges);
    for (std::size_t i = 0; i < waves.to_next.size(); ++i) {
        const bool same_row = waves.records[i].place.y == waves.records[i + 1].place.y;
        const bool same_wave =
            is_left_of_block(scene, waves.gauges[i].x) == is_left_of_block(scene, waves.gauges[i + 1].x);
        if (!same_row || !same_wave) waves.to_next[i] = {};
    }
    std::vector<analysis::GaugeWave> of_the_wave_to_the_right = waves.gauges;
    std::erase_if(of_the_wave_to_the_right,
                  [&](const analysis::GaugeWave& gauge) { return is_left_of_block(scene, gauge.x); });
    waves.overall = analysis::celerity_overall(of_the_wave_to_the_right);
    if (waves_run)
        waves.long_wave_celerity = analysis::long_wave_celerity(scene.water.depth, scene.domain.gravity);
    return waves;
}

void write_waves(const std::filesystem::path& path, const Waves& waves, const Provenance& provenance) {
    io::TableWriter table(path, provenance,
                          {"x",
                           "y",
                           "source",
                           "arrival",
                           "crest_time",
                           "crest",
                           "trough",
                           "height",
                           "period",
                           "greatest",
                           "greatest_time",
                           "lowest",
                           "mean_period",
                           "record_end",
                           "celerity",
                           "long_wave_celerity",
                           "error_percent",
                           "celerity_from_arrivals",
                           "error_percent_from_arrivals",
                           "depth",
                           "waves",
                           "H_s",
                           "H_max",
                           "H_mean",
                           "T_z",
                           "T_s",
                           "H_m0",
                           "T_p",
                           "T_m01",
                           "T_m02",
                           "energy_flux",
                           "energy",
                           "doubt"});
    for (std::size_t i = 0; i < waves.gauges.size(); ++i) {
        const analysis::GaugeWave& g = waves.gauges[i];
        const std::vector<double> seen{g.arrival, g.crest_time,  g.crest,     g.trough,
                                       g.height,  g.period,      g.greatest,  g.greatest_time,
                                       g.lowest,  g.mean_period, g.record_end};
        const auto celerity = i < waves.to_next.size() ? waves.to_next[i] : analysis::Celerity{};
        table.append_cells(
            row(waves, waves.records[i].place, waves.records[i].source, seen, celerity, waves.statistics[i]));
    }
    const std::vector<double> nothing(11, analysis::none);
    table.append_cells(row(waves, {}, "all", nothing, waves.overall, {}));
    table.finish();
}

std::string describe(const Waves& waves) {
    std::string text =
        "gauge (m)            source     arrival (s)  crest (s)  crest (m)  height (m)  period (s)  celerity "
        "to next "
        "(m/s)\n";
    for (std::size_t i = 0; i < waves.gauges.size(); ++i) {
        const analysis::GaugeWave& g = waves.gauges[i];
        std::string source = waves.records[i].source;
        source.resize(9, ' ');
        std::string place = io::place_name(waves.records[i].place);
        place.resize(std::max(place.size(), std::size_t{19}), ' ');
        text += place + "  " + source + cell(g.arrival, 13, 3) + cell(g.crest_time, 11, 3) +
                cell(g.crest, 11, 4) + cell(g.height, 12, 4) + cell(g.period, 12, 3) +
                cell(i < waves.to_next.size() ? waves.to_next[i].from_crests : analysis::none, 24, 3) + "\n";
    }
    if (waves.gauges.empty()) return "no gauges: name some with simulate.gauges or postprocess.gauges\n";
    // The arrivals' speed is left to waves.csv: the front of a wave that disperses runs ahead of its crest.
    return text + describe_speed(waves.overall.from_crests, waves.long_wave_celerity);
}

}  // namespace tidewater::postprocess
