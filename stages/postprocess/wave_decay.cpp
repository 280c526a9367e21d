#include "wave_decay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

double distance_of(const io::NamedPlace& place, const WavePath& path, const scene::Scene& scene) {
    const double along = (*place.x - path.source) * (path.to_the_right() ? 1.0 : -1.0);
    if (along <= 0.0 || !place.y) return along;
    return std::hypot(along, *place.y - 0.5 * scene.domain.size[1]);
}

double fitted(const WaveDecay& decay, double distance) {
    return decay.fit.amplitude * std::pow(distance / decay.depth, -decay.fit.exponent);
}

}  // namespace

WaveDecay find_decay(const Waves& waves, const WavePath& path, const scene::Scene& scene) {
    WaveDecay decay{.path = path, .depth = scene.water.depth, .points = {}, .fit = {}};
    for (std::size_t i = 0; i < waves.gauges.size(); ++i) {
        const io::NamedPlace& place = waves.records[i].place;
        const double distance = distance_of(place, path, scene);
        if (distance > 0.0) decay.points.push_back({place, distance, waves.gauges[i].crest});
    }
    std::ranges::stable_sort(decay.points, {}, &WaveDecay::Point::distance);
    std::vector<double> distance, crest;
    for (const WaveDecay::Point& point : decay.points) {
        distance.push_back(point.distance);
        crest.push_back(point.crest);
    }
    if (decay.depth > 0.0) decay.fit = analysis::fit_decay(distance, crest, decay.depth);
    return decay;
}

void write_decay(const std::filesystem::path& folder, const WaveDecay& decay, const Provenance& provenance) {
    io::TableWriter table(folder / "decay.csv", provenance,
                          {"x", "y", "distance", "distance_ratio", "crest", "fit"});
    for (const WaveDecay::Point& point : decay.points) {
        table.append(std::array{point.place.x.value_or(analysis::none),
                                point.place.y.value_or(analysis::none), point.distance,
                                point.distance / decay.depth, point.crest, fitted(decay, point.distance)});
    }
    table.finish();
    const analysis::AmplitudeDecay& fit = decay.fit;
    io::TableWriter one(
        folder / "decay_fit.csv", provenance,
        {"source", "amplitude", "exponent", "exponent_low", "exponent_high", "misfit", "gauges", "doubt"});
    std::vector<std::string> cells;
    for (const double value : {decay.path.source, fit.amplitude, fit.exponent, fit.exponent_low,
                               fit.exponent_high, fit.misfit, static_cast<double>(fit.gauges)})
        cells.push_back(io::format_number(value));
    cells.push_back(fit.doubt);
    one.append_cells(cells);
    one.finish();
}

std::string describe(const WaveDecay& decay) {
    const analysis::AmplitudeDecay& fit = decay.fit;
    if (decay.points.empty() || std::isnan(fit.exponent)) return {};
    std::string text =
        "the leading crest falls with distance r from x = " + io::format_fixed(decay.path.source, 1) +
        " m as r^-" + io::format_fixed(fit.exponent, 2);
    if (fit.exponent < 0.0) {
        text = "the leading crest rises with distance r from x = " + io::format_fixed(decay.path.source, 1) +
               " m as r^" + io::format_fixed(-fit.exponent, 2);
    }
    if (!std::isnan(fit.exponent_low)) {
        text += " (95 %: exponent of decay " + io::format_fixed(fit.exponent_low, 2) + " to " +
                io::format_fixed(fit.exponent_high, 2) + ")";
    }
    text += ", " + std::to_string(fit.gauges) + " gauges";
    return text + (fit.trustworthy() ? "" : ": not trustworthy, " + fit.doubt) + "\n";
}

}  // namespace tidewater::postprocess
