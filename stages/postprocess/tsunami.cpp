#include "tsunami.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/wave.h"
#include "io/table.h"
#include "io/text.h"
#include "wave_source.h"
#include "waves_3d.h"

namespace tidewater::postprocess {
namespace {

std::vector<WaveWay> ways_out(int number, const scene::Scene& scene) {
    std::vector<WaveWay> ways;
    for (const WavePath& path : block_wave_paths(shape_of(number, scene), scene))
        ways.push_back({.source = path.source, .wall = path.wall, .wave = {}});
    return ways;
}

double linear_celerity(const analysis::FirstWave& wave, const analysis::Slide& slide) {
    if (std::isnan(wave.celerity)) return analysis::none;
    const auto distance = [&](double time) {
        return analysis::linear_crest_distance(slide.depth, slide.gravity, time);
    };
    const double end = wave.track.back().time;
    return (distance(end) - distance(wave.formed)) / (end - wave.formed);
}

double error_percent(double value, double reference) { return 100.0 * (value / reference - 1.0); }

std::string fixed(double value, int decimals) { return io::format_fixed(value, decimals); }

// "F and P"; empty if all are within the range.
std::string what_is_outside(const analysis::ImpulseProduct& impulse) {
    std::vector<std::string> names;
    if (!impulse.froude_is_valid) names.push_back("F");
    if (!impulse.thickness_is_valid) names.push_back("S");
    if (!impulse.mass_is_valid) names.push_back("M");
    if (!impulse.value_is_valid) names.push_back("P");
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

std::string describe_slide(const Tsunami& t) {
    const std::string unit = t.dimension == 2 ? " kg per m" : " kg";
    std::string text = "block: " + fixed(t.block.mass, 1) + unit + ", its fastest point " +
                       fixed(t.slide.speed, 3) + " m/s at " + fixed(t.speed_time, 2) + " s";
    if (t.block_count > 1) {
        text += " (number " + std::to_string(t.block.number) + ", the heaviest of " +
                std::to_string(t.block_count) + ")";
    }
    const std::string names = what_is_outside(t.impulse);
    text += "\nF = " + fixed(t.slide.froude(), 3) + ", S = " + fixed(t.slide.thickness_ratio(), 3) +
            ", M = " + fixed(t.slide.mass_ratio(), 3) + "; impulse product P = " + fixed(t.impulse.value, 3);
    return text + (names.empty() ? "" : " (" + names + " " + outside_range + ")") + "\n";
}

std::string describe_way(const WaveWay& way, double reference) {
    const std::string name =
        std::string("first wave to the ") + (way.to_the_right() ? "right" : "left") + ": ";
    const analysis::FirstWave& wave = way.wave;
    if (wave.track.empty()) return name + "none was found\n";
    std::string text = name + "at most " + fixed(wave.greatest.amplitude, 4) + " m, at " +
                       fixed(wave.greatest.time, 2) + " s, " + fixed(wave.greatest.distance, 2) +
                       " m from x = " + fixed(way.source, 2) + " m; ";
    if (std::isnan(wave.celerity)) return text + "its celerity is not known, it ran too short a way\n";
    const double error = error_percent(wave.celerity, reference);
    return text + "from " + fixed(wave.formed, 2) + " s on " + fixed(wave.celerity, 3) + " m/s, " +
           (error < 0.0 ? "" : "+") + fixed(error, 1) + " % of sqrt(g D) = " + fixed(reference, 3) +
           " m/s (a linear wave, which disperses: " + fixed(way.linear_celerity, 3) + ")\n";
}

std::string describe_in_3d(const Tsunami& t, double amplitude) {
    std::string text = "in 3D (+-50 %), of " + fixed(amplitude, 4) + " m:";
    for (const double ratio : analysis::laboratory_distances) {
        text += (ratio == analysis::laboratory_distances.front() ? " " : ", ") +
                fixed(analysis::radial_factor(t.slide, ratio) * amplitude, 4) +
                " m at r/D = " + fixed(ratio, 0);
    }
    text += "\nby the impulse product: height " +
            fixed(t.impulse.height(analysis::laboratory_distances.front()), 4) +
            " m in 2D at x/D = " + fixed(analysis::laboratory_distances.front(), 0);
    return text + (t.impulse.is_valid() ? "" : std::string(", ") + outside_range) + "\n";
}

std::string describe_energy(const EnergySplit& energy, int dimension) {
    if (energy.time.empty()) return {};
    const std::string unit = dimension == 2 ? " J per m" : " J";
    return "energy at " + fixed(energy.time.back(), 2) + " s: block " + fixed(energy.block.back(), 1) + unit +
           ", water " + fixed(energy.water.back(), 1) + ", lost " + fixed(energy.lost.back(), 1) +
           "; the total's greatest rise above its start " + fixed(energy.greatest_rise(), 2) + unit + "\n";
}

}  // namespace

const WaveWay* Tsunami::main_way() const {
    const auto rank = [](const WaveWay& way) {
        return std::pair(!std::isnan(way.wave.celerity), way.wave.greatest.amplitude);
    };
    const WaveWay* first = nullptr;
    for (const WaveWay& way : ways) {
        if (way.wave.track.empty()) continue;
        if (!first || rank(way) > rank(*first)) first = &way;
    }
    return first;
}

Tsunami find_tsunami(const std::vector<Body>& bodies, const SurfaceProfiles& profiles, EnergySplit energy,
                     const scene::Scene& scene) {
    Tsunami t{.block = heaviest(bodies),
              .block_count = bodies.size(),
              .slide = {},
              .impulse = {},
              .ways = {},
              .energy = std::move(energy),
              .dimension = scene.dimension};
    t.slide = slide_of(t.block, scene);
    t.impulse = analysis::impulse_product(t.slide);
    const auto fastest = std::ranges::max_element(t.block.fastest) - t.block.fastest.begin();
    t.speed_time = t.block.time[static_cast<std::size_t>(fastest)];
    t.long_wave_celerity = analysis::long_wave_celerity(scene.water.depth, scene.domain.gravity);
    t.ways = ways_out(t.block.number, scene);
    for (WaveWay& way : t.ways) {
        way.wave = analysis::follow_first_wave(profiles.x, profiles.of_time,
                                               {.depth = scene.water.depth,
                                                .gravity = scene.domain.gravity,
                                                .cell_size = scene.domain.cell_size,
                                                .source = way.source,
                                                .wall = way.wall});
        way.linear_celerity = linear_celerity(way.wave, t.slide);
    }
    return t;
}

void write_first_wave(const std::filesystem::path& path, const Tsunami& tsunami,
                      const Provenance& provenance) {
    io::TableWriter table(
        path, provenance,
        {"time", "x", "distance", "amplitude", "amplitude_ratio", "time_from_greatest", "direction"});
    for (const WaveWay& way : tsunami.ways) {
        const analysis::CrestPoint& greatest = way.wave.greatest;
        for (const analysis::CrestPoint& crest : way.wave.track) {
            table.append(std::array{crest.time, crest.x, crest.distance, crest.amplitude,
                                    crest.amplitude / greatest.amplitude, crest.time - greatest.time,
                                    way.to_the_right() ? 1.0 : -1.0});
        }
    }
    table.finish();
}

void write_waves_3d(const std::filesystem::path& path, const Tsunami& tsunami, const Provenance& provenance) {
    const WaveWay* way = tsunami.main_way();
    const double greatest = way ? way->wave.greatest.amplitude : analysis::none;
    const auto here = [&](double r) { return way ? analysis::amplitude_at(way->wave, r) : analysis::none; };
    write_waves_3d(path, tsunami.slide, tsunami.impulse, greatest, here, provenance);
}

void write_tsunami(const std::filesystem::path& path, const Tsunami& tsunami, const Provenance& provenance) {
    io::TableWriter table(path, provenance,
                          {"block",
                           "mass",
                           "speed",
                           "speed_time",
                           "F",
                           "S",
                           "M",
                           "P",
                           "impulse_amplitude",
                           "direction",
                           "amplitude",
                           "amplitude_time",
                           "amplitude_x",
                           "amplitude_distance",
                           "celerity",
                           "celerity_from",
                           "long_wave_celerity",
                           "error_percent",
                           "linear_celerity",
                           "block_energy",
                           "water_energy",
                           "lost_energy",
                           "greatest_rise"});
    const WaveWay* way = tsunami.main_way();
    const analysis::FirstWave wave = way ? way->wave : analysis::FirstWave{};
    const double reference = tsunami.long_wave_celerity;
    const EnergySplit& energy = tsunami.energy;
    const auto last = [](const std::vector<double>& values) {
        return values.empty() ? analysis::none : values.back();
    };
    table.append(std::array{static_cast<double>(tsunami.block.number),
                            tsunami.block.mass,
                            tsunami.slide.speed,
                            tsunami.speed_time,
                            tsunami.slide.froude(),
                            tsunami.slide.thickness_ratio(),
                            tsunami.slide.mass_ratio(),
                            tsunami.impulse.value,
                            tsunami.impulse.amplitude,
                            way ? (way->to_the_right() ? 1.0 : -1.0) : analysis::none,
                            wave.greatest.amplitude,
                            wave.greatest.time,
                            wave.greatest.x,
                            wave.greatest.distance,
                            wave.celerity,
                            wave.formed,
                            reference,
                            error_percent(wave.celerity, reference),
                            way ? way->linear_celerity : analysis::none,
                            last(energy.block),
                            last(energy.water),
                            last(energy.lost),
                            energy.greatest_rise()});
    table.finish();
}

std::string describe(const Tsunami& tsunami) {
    std::string text = describe_slide(tsunami);
    for (const WaveWay& way : tsunami.ways) text += describe_way(way, tsunami.long_wave_celerity);
    if (const WaveWay* way = tsunami.main_way())
        text += describe_in_3d(tsunami, way->wave.greatest.amplitude);
    return text + describe_energy(tsunami.energy, tsunami.dimension);
}

}  // namespace tidewater::postprocess
