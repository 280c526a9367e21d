// The bodies of a scene: what they are bounded by, and what of it is exact.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glacier.h"
#include "terrain.h"

namespace tidewater {

// What is upright or turned but a box: the shelf and rigid blocks.
struct BoxBody {
    std::string name;  // of its level set
    geometry::Box box;
    const scene::Block* block = nullptr;  // null for the shelf
};

struct Bodies {
    Terrain terrain;
    geometry::Solid ground;  // empty without one
    std::vector<BoxBody> boxes;
    std::optional<Glacier> ice;

    geometry::Box tank, water_box;  // the latter holds the water
    geometry::Solid water;          // empty without it
    geometry::Solid open_water;     // and as it would be without anything in it
    double ground_volume = 0.0;     // within the tank, m³, in 2D m²
    double water_volume = 0.0;
};

// Of boxes, outlines and profiles that lie apart exact, else by geometry/solid.h's volume.
Bodies make_bodies(const scene::Scene& scene);

// Volume of a box in m³, in 2D its area in m².
double volume_of(const scene::Scene& scene, const geometry::Box& box);

geometry::Extent extent_of(const geometry::Box& box);

}  // namespace tidewater
