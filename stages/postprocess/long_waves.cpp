#include "long_waves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/wave.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr double nearest = 2.0, farthest = 0.75;  // in D; of the way to the wall

struct Seen {
    double distance;
    const GaugeRecord* record;
};

std::vector<Seen> gauges_on(const WaveWay& way, const std::vector<GaugeRecord>& records, double depth) {
    const double length = std::abs(way.wall - way.source), outward = way.to_the_right() ? 1.0 : -1.0;
    std::vector<Seen> seen;
    for (const GaugeRecord& record : records) {
        if (record.source != "run" || !record.place.x || record.place.y) continue;
        const double distance = outward * (*record.place.x - way.source);
        if (distance >= nearest * depth && distance <= farthest * length) seen.push_back({distance, &record});
    }
    std::ranges::sort(seen, {}, &Seen::distance);
    return seen;
}

LongWaves fit_way(const WaveWay& way, const std::vector<Seen>& seen, double depth, double gravity) {
    LongWaves waves{way.to_the_right(), analysis::none, {}};
    if (seen.empty()) return waves;
    const double length = std::abs(way.wall - way.source);
    waves.end = (2.0 * length - seen.back().distance) / analysis::long_wave_celerity(depth, gravity);
    const auto& all = seen.front().record->time;
    const auto count = static_cast<std::size_t>(std::ranges::upper_bound(all, waves.end) - all.begin());
    if (count < 4) return waves;
    waves.end = all[count - 1];
    std::vector<double> distance;
    std::vector<std::vector<double>> elevation;
    for (const Seen& gauge : seen) {
        const auto& whole = gauge.record->elevation;
        distance.push_back(gauge.distance);
        elevation.emplace_back(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(count));
    }
    waves.fit = analysis::fit_celerity(distance, std::span(all).first(count), elevation, depth, gravity);
    return waves;
}

double percent(double celerity, double reference) { return 100.0 * (celerity / reference - 1.0); }

}  // namespace

std::vector<LongWaves> fit_long_waves(const std::vector<GaugeRecord>& records,
                                      const std::vector<WaveWay>& ways, double depth, double gravity) {
    std::vector<LongWaves> waves;
    for (const WaveWay& way : ways)
        waves.push_back(fit_way(way, gauges_on(way, records, depth), depth, gravity));
    return waves;
}

void write_long_waves(const std::filesystem::path& path, const std::vector<LongWaves>& waves,
                      double long_wave_celerity, const Provenance& provenance) {
    io::TableWriter table(path, provenance,
                          {"direction", "pairs", "end", "celerity", "error", "explained",
                           "long_wave_celerity", "error_percent"});
    for (const LongWaves& way : waves) {
        const analysis::CelerityFit& fit = way.fit;
        table.append(std::array{way.to_the_right ? 1.0 : -1.0, static_cast<double>(fit.pairs), way.end,
                                fit.celerity, fit.error, fit.explained, long_wave_celerity,
                                percent(fit.celerity, long_wave_celerity)});
    }
    table.finish();
}

std::string describe(const std::vector<LongWaves>& waves, double long_wave_celerity) {
    std::string text;
    for (const LongWaves& way : waves) {
        const analysis::CelerityFit& fit = way.fit;
        if (std::isnan(fit.celerity)) continue;
        text += std::string("long waves to the ") + (way.to_the_right ? "right" : "left") + ": " +
                io::format_fixed(fit.celerity, 3) + " +- " + io::format_fixed(fit.error, 3) + " m/s (" +
                io::format_fixed(percent(fit.celerity, long_wave_celerity), 1) + " % off sqrt(g D)), from " +
                std::to_string(fit.pairs) + " pairs of gauges by linear dispersion, which explains " +
                io::format_fixed(100.0 * fit.explained, 0) + " % of what they saw\n";
    }
    return text;
}

}  // namespace tidewater::postprocess
