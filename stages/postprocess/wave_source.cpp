#include "wave_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tidewater::postprocess {

const scene::Block& wave_maker(const scene::Scene& scene) {
    return *std::ranges::max_element(scene.blocks, {}, [](const scene::Block& block) {
        double mass = block.density;
        for (const double edge : block.size) mass *= edge;
        return mass;
    });
}

bool is_left_of_block(const scene::Scene& scene, double x) {
    return scene.has("rigid") && x < wave_maker(scene).center.front();
}

std::vector<WavePath> block_wave_paths(const BlockShape& block, const scene::Scene& scene) {
    const double angle = block.angle * std::numbers::pi / 180.0, length = scene.domain.size.front();
    const double reach = 0.5 * (std::abs(std::cos(angle)) * block.size.front() +
                                std::abs(std::sin(angle)) * block.size.back());
    const double left = block.center.front() - reach, right = length - block.center.front() - reach;
    if (left <= scene.domain.cell_size) return {{0.0, length}};
    if (right <= scene.domain.cell_size) return {{length, 0.0}};
    return {{block.center.front(), length}, {block.center.front(), 0.0}};
}

WavePath main_wave_path(const scene::Scene& scene, double front) {
    if (!scene.has("rigid")) return {std::isnan(front) ? 0.0 : front, scene.domain.size.front()};
    const scene::Block& block = wave_maker(scene);
    return block_wave_paths({block.size, block.center, block.angle}, scene).front();
}

}  // namespace tidewater::postprocess
