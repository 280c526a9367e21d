#include "scene/scene.h"

#include <algorithm>
#include <array>
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

analysis::InitialWave initial_wave(const Scene& scene) {
    return {.kind = scene.wave.kind,
            .height = scene.wave.height,
            .length = scene.wave.length,
            .center = scene.wave.center,
            .depth = scene.water.depth,
            .gravity = scene.domain.gravity};
}

geometry::Box make_box(const Scene& scene, const std::vector<double>& center, const std::vector<double>& size,
                       double degrees) {
    const bool flat = scene.dimension == 2;
    return {.center = {center[0], flat ? 0.0 : center[1], center.back()},
            .half_size = {0.5 * size[0], flat ? plane_half_width * scene.domain.cell_size : 0.5 * size[1],
                          0.5 * size.back()},
            .angle = degrees * std::numbers::pi / 180.0};
}

geometry::Box block_box(const Scene& scene, const Scene::Block& block) {
    return make_box(scene, block.center, block.size, block.angle);
}

geometry::Box ice_box(const Scene& scene) {
    std::vector<double> center = scene.ice.corner;
    for (std::size_t axis = 0; axis < center.size(); ++axis) center[axis] += 0.5 * scene.ice.size[axis];
    return make_box(scene, center, scene.ice.size);
}

geometry::Polygon ice_outline(const Scene& scene) {
    geometry::Polygon outline;
    const auto& list = scene.ice.profile;
    for (std::size_t n = 0; n + 1 < list.size(); n += 2) outline.emplace_back(list[n], list[n + 1]);
    if (!outline.empty()) return outline;
    const auto corners = geometry::corners(ice_box(scene));
    return {corners.begin(), corners.end()};
}

bool Scene::has(std::string_view effect) const { return std::ranges::find(effects, effect) != effects.end(); }

geometry::Profile bed_profile(const Scene& scene) {
    geometry::Profile profile;
    profile.smooth = scene.bed.shape == BedShape::smooth;
    for (std::size_t i = 0; i + 1 < scene.bed.profile.size(); i += 2) {
        profile.x.push_back(scene.bed.profile[i]);
        profile.z.push_back(scene.bed.profile[i + 1]);
    }
    return profile;
}

}  // namespace tidewater::scene
