// The ice of a scene as a body: its outline or elevation model, its front, what ground and crevasses take of
// it.
#pragma once

#include <optional>

#include "common/cuts.h"
#include "common/ground.h"

namespace tidewater {

struct Glacier {
    geometry::Extent extent;        // that holds it
    geometry::Solid uncut;          // without crevasses and cracks
    geometry::Solid whole;          // without cracks
    geometry::Solid shown;          // as it is
    geometry::HeightField surface;  // from which crevasses are measured down; by node lines
    std::optional<geometry::Crevasses> crevasses;
    std::optional<geometry::Cracks> cracks;
    double uncut_volume = 0.0;     // m³, in 2D m²
    double volume = 0.0;           // of `whole`
    double front = 0.0;            // greatest x, m, at the still level where there is water
    double base = 0.0, top = 0.0;  // least and greatest z at the front, m
};

// Levels below a cell by which volumes are found (geometry/solid.h): in 2D to 1e-5, in 3D to 1e-4 of a
// glacier.
inline int volume_levels(int dimension) { return dimension == 2 ? 4 : 2; }

// `ground`: of the ground, empty without; `surface`: of an elevation model, if the scene names one.
Glacier make_glacier(const scene::Scene& scene, const geometry::Solid& ground,
                     const std::optional<geometry::HeightField>& surface);

// "crevasses: 12, depth 21 to 49 m (mean 35), …", for printing; and where what was made is off by more than a
// tenth from what was asked, that.
std::string describe_cuts(const Glacier& glacier, const scene::Scene& scene);

}  // namespace tidewater
