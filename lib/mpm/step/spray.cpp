#include "mpm/step/spray.h"

#include <algorithm>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/materials/water_material.h"
#include "mpm/particles/motion.h"
#include "mpm/particles/transfer_batch.h"
#include "mpm/step/crowding.h"

namespace tidewater::mpm {

template <int D, class Real>
void open_spray(const WaterModel& water, const Grid<D, Real>& grid, const std::vector<RigidBody>& rigid,
                std::vector<Particles<D, Real>>& bodies) {
    if (!keeps_to_room(water) || water.tension != WaterTension::separate) return;
    const auto lone = static_cast<Real>(std::pow(lone_share, D));
    const auto opened = static_cast<Real>(lone_opening);
    parallel_for(grid.particle_blocks.size(), [&](std::size_t slot) {
        if (!has_water(bodies, slot)) return;
        alignas(64) Tile<D, Real> tile;
        tile.fill(Node<Real>::Zero());
        load_fill(water.density, grid, rigid, slot, tile.data());
        const bool full =
            std::ranges::all_of(std::span(tile).first(Block<D>::tile_nodes),
                                [&](const Node<Real>& node) { return node[crowding_lane] >= lone; });
        if (full) return;
        TransferBatch<D, Real> batch;
        for (auto& particles : bodies) {
            if (particles.material != Material::water) continue;
            for_each_batch(particles, slot, [&](std::size_t first, int count, const auto* position) {
                locate<D, Real>(position, batch.stencil);
                gather_batch<D, Real>(tile.data()->data(), batch);
                for (int p = 0; p < count; ++p) {
                    Real& j = particles.j[first + static_cast<std::size_t>(p)];
                    if (batch.scalar[p] < lone) j = std::max(j, opened);
                }
            });
        }
    });
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                               \
    template void open_spray(const WaterModel&, const Grid<D, Real>&, const std::vector<RigidBody>&, \
                             std::vector<Particles<D, Real>>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
