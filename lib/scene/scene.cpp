#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace tidewater::scene {
namespace {

constexpr std::array<std::string_view, 3> stage_names{"geometry", "simulate", "postprocess"};

}  // namespace

std::string_view stage_name(Stage stage) { return stage_names[static_cast<std::size_t>(stage)]; }

std::optional<Stage> stage_named(std::string_view name) {
    const auto found = std::ranges::find(stage_names, name);
    if (found == stage_names.end()) return std::nullopt;
    return static_cast<Stage>(found - stage_names.begin());
}

geometry::Box make_box(const Scene& scene, const std::vector<double>& center, const std::vector<double>& size,
                       double degrees) {
    const bool flat = scene.dimension == 2;
    return {.center = {center[0], flat ? 0.0 : center[1], center.back()},
            .half_size = {0.5 * size[0], flat ? plane_half_width * scene.domain.cell_size : 0.5 * size[1],
                          0.5 * size.back()},
            .angle = degrees * std::numbers::pi / 180.0};
}

double particle_spacing(const Scene& scene) {
    return scene.domain.cell_size / static_cast<double>(scene.particles.per_axis);
}

double row_interval(const Scene& scene) {
    if (scene.simulate.gauge_interval > 0.0) return scene.simulate.gauge_interval;
    const double sound = 10.0 * scene.domain.cell_size / scene.water.model.sound_speed;
    const double least = std::max(0.1 * scene.simulate.snapshot_interval, sound);
    const double decade = std::floor(std::log10(least));
    for (const double digit : {1.0, 2.0, 5.0}) {
        const double interval = digit * std::pow(10.0, decade);
        if (interval > (1.0 - 1e-9) * least) return interval;
    }
    return std::pow(10.0, decade + 1.0);
}

bool Scene::has(std::string_view effect) const { return std::ranges::find(effects, effect) != effects.end(); }

}  // namespace tidewater::scene
