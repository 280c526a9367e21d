#include "profiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/surface.h"
#include "common/tank.h"
#include "core/types.h"
#include "io/table.h"

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

// A cell apart, m.
std::vector<double> places_along(const scene::Scene& scene) {
    const double cell = scene.domain.cell_size;
    const auto count = static_cast<std::size_t>(scene.domain.size.front() / cell + 1e-9);
    std::vector<double> x;
    for (std::size_t i = 0; i < count; ++i) x.push_back((static_cast<double>(i) + 0.5) * cell);
    return x;
}

std::vector<double> profile(const io::Snapshot& snapshot, const analysis::Tank& tank,
                            const std::vector<double>& x, const std::vector<analysis::Place>& places) {
    auto elevation =
        analysis::surface_elevation({snapshot.points, snapshot.volume, snapshot.material}, tank, places);
    const std::vector<bool> covered = covered_places(snapshot, tank, x);
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (covered[i]) elevation[i] = analysis::none;
    }
    return elevation;
}

}  // namespace

bool makes_first_wave(const scene::Scene& scene) {
    return scene.has("rigid") && scene.has("water") && scene.domain.gravity > 0.0;
}

FrameProduct profile_product(const StageContext& context, const Ground& ground) {
    const scene::Scene& scene = context.scene;
    const std::vector<double> x = places_along(scene);
    scene::Points points;
    for (const double each : x) points.push_back({each});
    return {
        .name = "profile",
        .settings = {},
        .files =
            [any = makes_first_wave(scene)](std::size_t frame) {
                return any ? std::vector{frame_file("profile", frame)} : std::vector<std::string>{};
            },
        .make =
            [x, tank = make_tank(scene), places = gauge_places(points, scene, ground),
             folder = context.folder](std::size_t frame, const io::Snapshot& snapshot,
                                      const Provenance& provenance) {
                const auto elevation = profile(snapshot, tank, x, places);
                io::TableWriter table(folder / frame_file("profile", frame), provenance, {"x", "elevation"});
                for (std::size_t i = 0; i < x.size(); ++i) table.append(std::array{x[i], elevation[i]});
                table.finish();
            },
        .follows = false};
}

SurfaceProfiles gather_profiles(const StageContext& context, const Frames& frames) {
    SurfaceProfiles profiles;
    if (!makes_first_wave(context.scene)) return profiles;
    profiles.x = places_along(context.scene);
    for (std::size_t frame = 0; frame < frames.times.size(); ++frame) {
        const auto path = context.folder / frame_file("profile", frame);
        profiles.of_time.push_back(
            {frames.times[frame], io::require_column(io::read_table(path), "elevation", path)});
    }
    return profiles;
}

}  // namespace tidewater::postprocess
