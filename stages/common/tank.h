// A scene's tank and gauges as the analysis takes them, the same for simulate's gauges and those read from
// snapshots.
#pragma once

#include <vector>

#include "analysis/surface.h"
#include "scene/scene.h"

namespace tidewater {

inline analysis::Tank make_tank(const scene::Scene& scene) {
    const auto& size = scene.domain.size;
    return {.dimension = scene.dimension,
            .size = {size.front(), scene.dimension == 3 ? size[1] : 0.0, size.back()},
            .cell_size = scene.domain.cell_size,
            .still_level = scene.water.depth};
}

// In 3D on the middle of the tank's width.
inline std::vector<analysis::Place> gauge_places(const std::vector<double>& gauges,
                                                 const scene::Scene& scene) {
    const geometry::Profile bed = bed_profile(scene);
    std::vector<analysis::Place> places;
    for (const double x : gauges) {
        const double height = scene.has("bed") ? bed.height(x) : 0.0;
        places.push_back({.x = x, .y = 0.5 * make_tank(scene).size[1], .bed = height});
    }
    return places;
}

}  // namespace tidewater
