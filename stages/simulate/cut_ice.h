// What crevasses and cracks take of the particles of ice.
#pragma once

#include <openvdb/openvdb.h>

#include <functional>
#include <memory>
#include <vector>

#include "common/cuts.h"
#include "mpm/step/start.h"

namespace tidewater {

struct Cuts {
    std::shared_ptr<const geometry::Crevasses> crevasses;  // null without
    std::shared_ptr<const geometry::HeightField> surface;  // from which they are measured down
    std::optional<geometry::Cracks> cracks;

    // For Seeding::keep: whether a place is in no crevasse; empty without crevasses.
    std::function<bool(const geometry::Point&)> keep() const;
};

// From the grids of geometry.vdb, which is `file`, and cracks.csv beside it. Throws InputError.
Cuts read_cuts(const scene::Scene& scene, const std::vector<openvdb::FloatGrid::Ptr>& grids,
               const std::filesystem::path& file);

// With b = max(width, particle spacing), so that a crack parts the particles on its sides: those nearer to a
// wall between Voronoi cells than b/2 keep `cohesion` of their strength. Of cohesion 0, those nearer than
// width/2 are left out with their mass, the others have failed.
template <int D>
void crack(const geometry::Cracks& cracks, const scene::Scene& scene, typename mpm::Start<D>::Body& ice);

}  // namespace tidewater
