#include "mpm/outlet.h"

#include <algorithm>

#include "mpm/ledger.h"
#include "mpm/motion.h"

namespace tidewater::mpm {
namespace {

// Whether a particle of the block may have passed; it may have drifted half a cell out of its block.
template <int D>
bool reaches(const Layout<D>& layout, const Outlet& outlet, const Index<D>& block) {
    const auto end = [&](std::size_t axis) {
        return layout.cell_size * (layout.first_node(block[axis]) + Block<D>::width + 1);
    };
    return end(0) > outlet.from && end(D - 1) > outlet.level;
}

// The particles of `slot` that have passed, in order.
template <int D, class Real>
std::vector<std::size_t> passed(const Simulation<D, Real>& s, const Particles<D, Real>& particles,
                                std::size_t slot) {
    std::vector<std::size_t> gone;
    const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
    const Outlet& outlet = s.parameters.outlet;
    if (!reaches<D>(s.grid.layout, outlet, block)) return gone;
    for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
        const Vector<D, double> at = global_position(s.grid.layout, block, particles, p);
        if (at[0] > outlet.from && at[D - 1] > outlet.level) gone.push_back(p);
    }
    return gone;
}

template <int D, class Real>
void account(Simulation<D, Real>& s, const Particles<D, Real>& particles, std::size_t slot,
             const std::vector<std::size_t>& gone) {
    const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
    Tile<D, Real> tile;
    load_velocities(s.grid, slot, Parity::velocity, tile.data());
    for (const std::size_t p : gone) {
        const Ledger<D> part = particle_ledger(s, particles, block, p, tile);
        s.outflow.mass += part.mass;
        s.outflow.momentum += part.momentum;
        s.outflow.energy += part.kinetic + part.gravitational + part.elastic;
    }
}

// Keeps the rest of every column; `gone` is rising.
template <int D, class Real>
void remove_particles(const std::vector<std::size_t>& gone, Particles<D, Real>& particles) {
    const std::size_t count = particles.size();
    for_each_column(particles, [&](const std::string&, auto& column) {
        if (column.empty()) return;
        std::size_t to = gone.front();
        for (std::size_t next = 0, p = to; p < count; ++p) {
            if (next < gone.size() && p == gone[next])
                ++next;
            else
                column[to++] = column[p];
        }
        column.resize(to);
    });
    for (auto& begin : particles.begin) {
        const auto before = std::lower_bound(gone.begin(), gone.end(), begin) - gone.begin();
        begin -= static_cast<std::uint32_t>(before);
    }
}

}  // namespace

template <int D, class Real>
void drain(Simulation<D, Real>& s) {
    for (auto& particles : s.bodies) {
        if (particles.material != Material::water) continue;
        std::vector<std::size_t> gone;
        for (std::size_t slot = 0; slot < s.grid.particle_blocks.size(); ++slot) {
            const auto of_block = passed(s, particles, slot);
            if (of_block.empty()) continue;
            account(s, particles, slot, of_block);
            gone.insert(gone.end(), of_block.begin(), of_block.end());
        }
        if (!gone.empty()) remove_particles(gone, particles);
    }
}

#define TIDEWATER_INSTANTIATE(D, Real) template void drain(Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
