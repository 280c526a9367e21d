#include "mpm/pressure.h"

#include <algorithm>

#include "mpm/transfer.h"

namespace tidewater::mpm {

namespace {

// Leaves the average pressure in the first component of the nodes' velocity.
template <int D, class Real>
void average_on_grid(Simulation<D, Real>& s) {
    // Volume takes the place of mass and pressure that of one velocity component: P2G then averages it.
    const auto bulk = static_cast<Real>(s.parameters.water.bulk_modulus());
    const int exponent = s.parameters.water.exponent;
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        Node<Real>* tile = s.grid.tile(slot);
        std::fill_n(tile, Block<D>::tile_nodes, Node<Real>::Zero());
        for (const auto& particles : s.bodies) {
            if (particles.material != Material::water) continue;
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                const Real volume = static_cast<Real>(particles.volume) * (Real(1) + particles.j[p]);
                Vector<D, Real> weighted = Vector<D, Real>::Zero();
                weighted[0] = volume * water_pressure(particles.j[p], bulk, exponent);
                scatter<D, Real>(particles.position[p], volume, weighted, Matrix<D, Real>::Zero(), tile);
            }
        }
    });
    parallel_for(s.grid.node_blocks.size(), [&](std::size_t slot) {
        sum_tiles(s.grid, slot, s.grid.block_nodes(slot));
        divide_by_mass<D>(s.grid.block_nodes(slot));
    });
}

}  // namespace

template <int D, class Real>
std::vector<std::vector<float>> grid_pressure(Simulation<D, Real>& s) {
    average_on_grid(s);
    std::vector<std::vector<float>> pressure;
    for (const auto& particles : s.bodies) pressure.emplace_back(particles.size());
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        std::array<Node<Real>, static_cast<std::size_t>(Block<D>::tile_nodes)> tile;
        load_tile(s.grid, slot, tile.data());
        for (std::size_t body = 0; body < s.bodies.size(); ++body) {
            const Particles<D, Real>& particles = s.bodies[body];
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                Vector<D, Real> value;
                Matrix<D, Real> unused;
                gather<D, Real>(particles.position[p], tile.data(), value, unused);
                pressure[body][p] = static_cast<float>(value[0]);
            }
        }
    });
    return pressure;
}

#define TIDEWATER_INSTANTIATE(D, Real) \
    template std::vector<std::vector<float>> grid_pressure(Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
