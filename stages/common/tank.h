// A scene's tank and gauges as the analysis takes them, the same for simulate's gauges and those read from
// snapshots.
#pragma once

#include <vector>

#include "analysis/surface.h"
#include "common/ground.h"
#include "io/places.h"
#include "scene/scene.h"

namespace tidewater {

inline analysis::Tank make_tank(const scene::Scene& scene) {
    const auto& size = scene.domain.size;
    return {.dimension = scene.dimension,
            .size = {size.front(), scene.dimension == 3 ? size[1] : 0.0, size.back()},
            .cell_size = scene.domain.cell_size,
            .still_level = scene.water.depth};
}

// A gauge that tells only its x is on the middle of the tank's width.
inline std::vector<analysis::Place> gauge_places(const scene::Points& gauges, const scene::Scene& scene,
                                                 const Ground& ground) {
    const double middle = 0.5 * make_tank(scene).size[1];
    std::vector<analysis::Place> places;
    for (const auto& gauge : gauges) {
        const double y = gauge.size() > 1 ? gauge[1] : middle;
        places.push_back({.x = gauge[0], .y = y, .bed = ground.height(gauge[0], y)});
    }
    return places;
}

// What a table calls a gauge: "x=2", "x=2 y=0.5".
inline io::NamedPlace gauge_name(const std::vector<double>& gauge) {
    io::NamedPlace name{.x = gauge[0]};
    if (gauge.size() > 1) name.y = gauge[1];
    return name;
}

}  // namespace tidewater
