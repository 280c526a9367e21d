#include "cut_ice.h"

#include <algorithm>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/height_grid.h"

namespace tidewater {
namespace {

constexpr std::size_t points_per_task = 4096;

// To the nearest wall between Voronoi cells, of each point, m.
template <int D>
std::vector<float> wall_distances(const geometry::Cracks& cracks,
                                  const std::vector<Vector<D, double>>& points) {
    const geometry::CrackFinder finder(cracks);
    std::vector<float> distance(points.size());
    parallel_for(
        points.size(),
        [&](std::size_t p) {
            const auto& x = points[p];
            distance[p] = static_cast<float>(finder.wall_distance({x[0], D == 3 ? x[1] : 0.0, x[D - 1]}));
        },
        points_per_task);
    return distance;
}

}  // namespace

std::function<bool(const geometry::Point&)> Cuts::keep() const {
    if (!crevasses) return {};
    return [list = crevasses, top = surface](const geometry::Point& at) {
        return signed_distance(*list, at[0], at[1], top->height(at[0], at[1]) - at[2]) > 0.0;
    };
}

Cuts read_cuts(const scene::Scene& scene, const std::vector<openvdb::FloatGrid::Ptr>& grids,
               const std::filesystem::path& file) {
    Cuts cuts;
    if (scene.has("cracks")) cuts.cracks = read_cracks(file.parent_path() / "cracks.csv", scene);
    const auto crevasses = scene_crevasses(scene);
    if (!crevasses) return cuts;
    cuts.crevasses = std::make_shared<geometry::Crevasses>(*crevasses);
    const auto grid = std::ranges::find(grids, geometry::ice_surface, &openvdb::FloatGrid::getName);
    if (grid == grids.end()) {
        throw InputError(file.string() + ": has no '" + geometry::ice_surface +
                         "', from which crevasses are measured; run tidewater-geometry again");
    }
    cuts.surface = std::make_shared<geometry::HeightField>(geometry::height_field(**grid));
    return cuts;
}

template <int D>
void crack(const geometry::Cracks& cracks, const scene::Scene& scene, typename mpm::Start<D>::Body& ice) {
    const double width = scene.cracks.width, spacing = scene.domain.cell_size / scene.particles.per_axis;
    const auto cohesion = static_cast<float>(scene.cracks.cohesion);
    const std::vector<float> distance = wall_distances<D>(cracks, ice.points);
    std::size_t kept = 0;
    for (std::size_t p = 0; p < ice.points.size(); ++p) {
        if (cohesion == 0.0f && distance[p] < 0.5 * width) continue;
        ice.strength.push_back(distance[p] < 0.5 * std::max(width, spacing) ? cohesion : 1.0f);
        ice.points[kept++] = ice.points[p];
    }
    const double share =
        static_cast<double>(kept) / static_cast<double>(std::max<std::size_t>(ice.points.size(), 1));
    ice.points.resize(kept);
    ice.mass *= share;
    ice.volume *= share;
}

template void crack<2>(const geometry::Cracks&, const scene::Scene&, mpm::Start<2>::Body&);
template void crack<3>(const geometry::Cracks&, const scene::Scene&, mpm::Start<3>::Body&);

}  // namespace tidewater
