#include "calving_wave.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "break_records.h"
#include "io/table.h"
#include "io/text.h"
#include "waves_3d.h"

namespace tidewater::postprocess {
namespace {

std::set<std::uint32_t> icebergs_of(const MainEvent& event, const IcebergTables& tables) {
    std::set<std::uint32_t> icebergs;
    for (const IcebergStory& story : tables.stories) {
        if (story.calved && story.detachment_time == event.calving.time) icebergs.insert(story.iceberg);
    }
    return icebergs;
}

// Of the icebergs' centre of mass when it is fastest, and when; all are ice of one density.
void find_speed(const IcebergTables& tables, const std::set<std::uint32_t>& icebergs, CalvingWave& wave) {
    struct Sum {
        double volume = 0.0;
        std::array<double, 3> momentum{};
    };
    std::map<double, Sum> by_time;
    const std::array columns{tables.column("velocity_x"), tables.column("velocity_y"),
                             tables.column("velocity_z")};
    for (const IcebergRow& row : tables.rows) {
        if (!icebergs.contains(row.iceberg)) continue;
        Sum& sum = by_time[row.time];
        sum.volume += row.volume;
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum.momentum[axis] += row.volume * row.values.at(columns[axis]);
    }
    for (const auto& [time, sum] : by_time) {
        const auto& m = sum.momentum;
        const double speed = std::hypot(m[0], m[1], m[2]) / sum.volume;
        if (speed <= wave.slide.speed) continue;
        wave.slide.speed = speed;
        wave.speed_time = time;
    }
}

void find_amplitude(const Waves& waves, CalvingWave& wave) {
    for (const analysis::GaugeWave& gauge : waves.gauges) {
        if (!(gauge.x > wave.front) || std::isnan(gauge.crest) || gauge.crest <= wave.amplitude) continue;
        wave.amplitude = gauge.crest;
        wave.amplitude_x = gauge.x;
    }
}

}  // namespace

std::optional<CalvingWave> find_calving_wave(const StageContext& context, const IcebergTables& tables,
                                             const Waves& waves, const Ground& ground, double front) {
    const scene::Scene& scene = context.scene;
    const auto event = read_main_event(context.folder);
    const double middle = scene.dimension == 3 ? 0.5 * scene.domain.size[1] : 0.0;
    if (!scene.has("water") || !event || std::isnan(event->frame) || std::isnan(front)) return {};
    const double depth = scene.water.depth - ground.height(front, middle);
    const analysis::Calving& ice = event->calving;
    if (!(depth > 0.0) || !(scene.domain.gravity > 0.0) || !(ice.length > 0.0)) return {};
    CalvingWave wave{.slide = {.speed = 0.0,
                               .thickness = ice.length,
                               .mass = ice.volume * scene.ice.model.density,
                               .width = scene.dimension == 3 ? ice.volume / (ice.length * ice.height) : 1.0,
                               .depth = depth,
                               .water_density = scene.water.model.density,
                               .gravity = scene.domain.gravity},
                     .front = front};
    find_speed(tables, icebergs_of(*event, tables), wave);
    find_amplitude(waves, wave);
    wave.impulse = analysis::impulse_product(wave.slide);
    return wave;
}

void write_calving_wave(const StageContext& context, const CalvingWave& wave) {
    io::TableWriter table(context.folder / "calving_wave.csv", context.provenance,
                          {"mass", "width", "thickness", "depth", "speed", "speed_time", "F", "S", "M", "P",
                           "impulse_amplitude", "front", "amplitude", "amplitude_x"});
    const analysis::Slide& slide = wave.slide;
    table.append(std::array{slide.mass, slide.width, slide.thickness, slide.depth, slide.speed,
                            wave.speed_time, slide.froude(), slide.thickness_ratio(), slide.mass_ratio(),
                            wave.impulse.value, wave.impulse.amplitude, wave.front, wave.amplitude,
                            wave.amplitude_x});
    table.finish();
    write_waves_3d(
        context.folder / "waves_3d.csv", slide, wave.impulse, wave.amplitude,
        [](double) { return analysis::none; }, context.provenance);
}

std::string describe(const CalvingWave& wave) {
    const analysis::Slide& slide = wave.slide;
    const auto fixed = [](double value) { return io::format_fixed(value, 2); };
    std::string text = "as a slide into " + io::format_fixed(slide.depth, 0) + " m of water: F " +
                       fixed(slide.froude()) + ", S " + fixed(slide.thickness_ratio()) + ", M " +
                       fixed(slide.mass_ratio()) + "; impulse product " + fixed(wave.impulse.value) + ", " +
                       io::format_fixed(wave.impulse.amplitude, 1) + " m high near the impact" +
                       (wave.impulse.is_valid() ? "" : " (outside the validated range)") + "\n";
    if (std::isnan(wave.amplitude)) return text;
    constexpr double ratio = analysis::laboratory_distances.back();
    const double middle = analysis::radial_factor(slide, ratio) * wave.amplitude;
    return text + "in 3D its crest of " + io::format_fixed(wave.amplitude, 1) + " m would be " +
           fixed((1.0 - analysis::radial_scatter) * middle) + " to " +
           fixed((1.0 + analysis::radial_scatter) * middle) + " m at a distance of " +
           io::format_fixed(ratio, 0) + " depths\n";
}

}  // namespace tidewater::postprocess
