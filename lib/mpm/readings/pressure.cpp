#include "mpm/readings/pressure.h"

#include "mpm/base/instantiate.h"
#include "mpm/particles/motion.h"

namespace tidewater::mpm {

namespace {

// Nodes with the average pressure around them in the first component of their velocity.
template <int D, class Real>
std::vector<Node<Real>> average_on_grid(const Simulation<D, Real>& s) {
    // P2G averages the pressure if volume takes the place of mass and pressure that of a velocity component.
    std::vector<Node<Real>> tiles(s.grid.tiles.size(), Node<Real>::Zero());
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        Node<Real>* tile = tiles.data() + slot * Block<D>::tile_size;
        for (const auto& particles : s.bodies) {
            if (particles.material != Material::water) continue;
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                const Real volume = static_cast<Real>(particles.volume) * (Real(1) + particles.j[p]);
                Vector<D, Real> weighted = Vector<D, Real>::Zero();
                weighted[0] = volume * water_pressure(particles.j[p], s.parameters.water);
                scatter<D, Real>(local_position(particles, p), volume, weighted, Matrix<D, Real>::Zero(),
                                 tile);
            }
        }
        fold<D, Real>(s.grid.layout, block_at<D>(s.grid.particle_blocks[slot]), Parity::even, tile);
    });
    std::vector<Node<Real>> nodes(s.grid.nodes.size());
    parallel_for(s.grid.node_blocks.size(), [&](std::size_t slot) {
        Node<Real>* block = nodes.data() + slot * Block<D>::nodes;
        sum_tiles<D, Real>(s.grid.tiles_of_node[slot], tiles.data(), block);
        momentum_to_velocity<D, Real>(Real(0), block);
    });
    return nodes;
}

}  // namespace

template <int D, class Real>
std::vector<std::vector<float>> grid_pressure(const Simulation<D, Real>& s) {
    const std::vector<Node<Real>> nodes = average_on_grid(s);
    std::vector<std::vector<float>> pressure;
    for (const auto& particles : s.bodies) pressure.emplace_back(particles.size());
    parallel_for(s.grid.particle_blocks.size(), [&](std::size_t slot) {
        Tile<D, Real> tile;
        load_tile(s.grid, nodes, slot, tile.data());
        unfold<D, Real>(s.grid.layout, block_at<D>(s.grid.particle_blocks[slot]), Parity::even, tile.data());
        for (std::size_t body = 0; body < s.bodies.size(); ++body) {
            const Particles<D, Real>& particles = s.bodies[body];
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                Vector<D, Real> value;
                Matrix<D, Real> unused;
                gather<D, Real>(local_position(particles, p), tile.data(), value, unused);
                pressure[body][p] = static_cast<float>(value[0]);
            }
        }
    });
    return pressure;
}

#define TIDEWATER_INSTANTIATE(D, Real) \
    template std::vector<std::vector<float>> grid_pressure(const Simulation<D, Real>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
