#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "analysis/wave_theory.h"
#include "gauges.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr double taper = 0.2;      // of a short record's window: a tenth at either end
constexpr double shortest = 4.0;   // cells, of a wave that is resolved
constexpr double many_waves = 24;  // whose record is cut into segments of a third of it or less

struct Part {
    std::span<const double> time, value;
};

Part part_of(const GaugeRecord& record, const std::vector<double>& value, double from, double to) {
    const auto first = std::ranges::lower_bound(record.time, from) - record.time.begin();
    const auto end = std::ranges::upper_bound(record.time, to) - record.time.begin();
    const auto count = static_cast<std::size_t>(std::max(end - first, std::ptrdiff_t{0}));
    return {std::span(record.time).subspan(static_cast<std::size_t>(first), count),
            std::span(value).subspan(static_cast<std::size_t>(first), count)};
}

// A long record by Welch's method with Hann's window, about twelve waves to a segment; a short one whole.
analysis::SpectrumSettings spectrum_settings(double waves) {
    if (waves < many_waves) return {.segments = 1, .taper = taper};
    return {.segments = std::max(3, static_cast<int>(2.0 * waves / 12.0) - 1), .taper = 1.0};
}

double greatest_excursion(std::span<const double> value) {
    double greatest = 0.0;
    for (const double v : value) {
        if (std::abs(v) > greatest) greatest = std::abs(v);
    }
    return greatest;
}

void add_doubt(std::string& doubts, const std::string& doubt) {
    if (!doubt.empty()) doubts += (doubts.empty() ? "" : "; ") + doubt;
}

// From the arrival until a reflection may be back.
void measure_energy(const GaugeRecord& record, const std::vector<double>& value,
                    const analysis::GaugeWave& wave, const scene::Scene& scene, GaugeStatistics& s) {
    const analysis::WaterColumn water{
        .depth = s.depth, .density = scene.water.model.density, .gravity = scene.domain.gravity};
    const bool open = scene.has("sponge") || scene.has("outlet");
    const double end = open ? record.time.back() : wave.record_end;
    const Part passed = part_of(record, value, wave.arrival, end);
    s.energy = analysis::long_wave_energy(passed.time, passed.value, water);
    const analysis::Spectrum spectrum =
        analysis::wave_spectrum(passed.time, passed.value, {.segments = 1, .taper = taper});
    if (spectrum.doubt.empty()) s.energy_flux = analysis::spectral_energy_flux(spectrum, water);
}

}  // namespace

GaugeStatistics gauge_statistics(const GaugeRecord& record, const analysis::GaugeWave& wave, double depth,
                                 const scene::Scene& scene) {
    GaugeStatistics s;
    s.depth = depth;
    if (std::isnan(wave.arrival) || !(depth > 0.0)) {
        s.doubt = std::isnan(wave.arrival) ? "no wave" : "the gauge stands on land";
        return s;
    }
    const std::vector<double> value =
        analysis::change_from_rest(record.time, record.elevation, scene.water.depth, scene.domain.gravity)
            .value;
    const double zero = scene.has("wave") ? analysis::mean_over_time(record.time, value) : 0.0;
    const double margin = scene.postprocess.arrival_threshold * greatest_excursion(value);
    s.waves = analysis::wave_statistics(analysis::zero_crossing_waves(record.time, value, zero, margin));
    const double end = record.time.back();
    const Part whole = part_of(record, value, wave.arrival, end);
    const double waves = (end - wave.arrival) / s.waves.mean_period;
    s.spectrum = analysis::wave_spectrum(whole.time, whole.value, spectrum_settings(waves));
    measure_energy(record, value, wave, scene, s);
    add_doubt(s.doubt, s.waves.doubt);
    add_doubt(s.doubt, s.spectrum.doubt);
    return s;
}

double highest_frequency(double depth, const scene::Scene& scene) {
    const double wavenumber = 2.0 * std::numbers::pi / (shortest * scene.domain.cell_size);
    return analysis::angular_frequency(wavenumber, depth, scene.domain.gravity) / (2.0 * std::numbers::pi);
}

void write_spectra(const std::filesystem::path& path, const Waves& waves, const scene::Scene& scene,
                   const Provenance& provenance) {
    io::TableWriter table(path, provenance, {"x", "y", "source", "frequency", "density"});
    for (std::size_t i = 0; i < waves.records.size(); ++i) {
        const GaugeRecord& record = waves.records[i];
        const analysis::Spectrum& spectrum = waves.statistics[i].spectrum;
        for (std::size_t k = 0; k < spectrum.frequency.size(); ++k) {
            if (spectrum.frequency[k] > highest_frequency(waves.statistics[i].depth, scene)) break;
            table.append_cells(std::vector{io::format_number(record.place.x.value_or(analysis::none)),
                                           io::format_number(record.place.y.value_or(analysis::none)),
                                           record.source, io::format_number(spectrum.frequency[k]),
                                           io::format_number(spectrum.density[k])});
        }
    }
    table.finish();
}

}  // namespace tidewater::postprocess
