#include "mpm/step/outlet.h"

#include "mpm/state/simulation.h"

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

}  // namespace

template <int D, class Real>
void drain(Simulation<D, Real>& s) {
    for (auto& particles : s.bodies) {
        if (particles.material != Material::water) continue;
        std::vector<std::size_t> gone;
        for (std::size_t slot = 0; slot < s.grid.particle_blocks.size(); ++slot) {
            const auto of_block = passed(s, particles, slot);
            gone.insert(gone.end(), of_block.begin(), of_block.end());
        }
        let_out(gone, particles, s);
    }
}

#define TIDEWATER_INSTANTIATE(D, Real) template void drain(Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
