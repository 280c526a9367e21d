// A scene's elevation models, read and checked.
#pragma once

#include <optional>
#include <string>

#include "common/ground.h"
#include "geometry/solid.h"

namespace tidewater {

struct Terrain {
    Ground ground;
    std::optional<geometry::HeightField> surface;  // of the ice, if an elevation model gives it
    std::string report;                            // what was read, a line each
};

// At every node line of the scene. Throws InputError for what io/elevation_file.h refuses, ground outside of
// the tank, and a surface that is nowhere above the ground.
Terrain read_terrain(const scene::Scene& scene);

// The ground as a body; empty without one.
geometry::Solid ground_solid(const scene::Scene& scene, const Ground& ground);

}  // namespace tidewater
