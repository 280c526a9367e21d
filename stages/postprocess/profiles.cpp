#include "profiles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/surface.h"
#include "common/tank.h"
#include "core/types.h"

namespace tidewater::postprocess {
namespace {

// Places that a particle of a block is near to, along x and, in 3D, across.
std::vector<bool> covered_places(const io::Snapshot& snapshot, const analysis::Tank& tank,
                                 const std::vector<double>& x) {
    std::vector<bool> covered(x.size(), false);
    const double reach = tank.cell_size, last = static_cast<double>(x.size()) - 1.0;
    for (std::size_t p = 0; p < snapshot.particle_count(); ++p) {
        if (static_cast<Material>(snapshot.material[p]) != Material::rigid) continue;
        if (tank.dimension == 3 && std::abs(snapshot.points[3 * p + 1] - 0.5 * tank.size[1]) > reach)
            continue;
        const double at = snapshot.points[3 * p] / tank.cell_size - 0.5;  // in places
        const auto first = static_cast<std::size_t>(std::clamp(std::ceil(at - 1.0), 0.0, last));
        const auto end = static_cast<std::size_t>(std::clamp(std::floor(at + 1.0), 0.0, last));
        for (std::size_t i = first; i <= end; ++i) covered[i] = true;
    }
    return covered;
}

}  // namespace

bool makes_first_wave(const scene::Scene& scene) {
    return scene.has("rigid") && scene.has("water") && scene.domain.gravity > 0.0;
}

SurfaceProfiles start_profiles(const scene::Scene& scene) {
    SurfaceProfiles profiles;
    if (!makes_first_wave(scene)) return profiles;
    const double cell = scene.domain.cell_size;
    const auto count = static_cast<std::size_t>(scene.domain.size.front() / cell + 1e-9);
    for (std::size_t i = 0; i < count; ++i) profiles.x.push_back((static_cast<double>(i) + 0.5) * cell);
    return profiles;
}

void append_profile(const io::Snapshot& snapshot, const scene::Scene& scene, const Ground& ground,
                    SurfaceProfiles& profiles) {
    if (profiles.x.empty()) return;
    const analysis::Tank tank = make_tank(scene);
    scene::Points places;
    for (const double x : profiles.x) places.push_back({x});
    auto elevation = analysis::surface_elevation({snapshot.points, snapshot.volume, snapshot.material}, tank,
                                                 gauge_places(places, scene, ground));
    const std::vector<bool> covered = covered_places(snapshot, tank, profiles.x);
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (covered[i]) elevation[i] = analysis::none;
    }
    profiles.of_time.push_back({snapshot.time, std::move(elevation)});
}

}  // namespace tidewater::postprocess
