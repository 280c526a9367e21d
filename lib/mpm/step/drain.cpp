#include "mpm/step/drain.h"

#include "mpm/base/instantiate.h"
#include "mpm/step/take_out.h"

namespace tidewater::mpm {
namespace {

// Whether a particle of the block may have passed the outlet; it may have drifted half a cell out of the
// block.
template <int D>
bool reaches(const Layout<D>& layout, const Outlet& outlet, const Index<D>& block) {
    const auto end = [&](std::size_t axis) {
        return layout.cell_size * (layout.first_node(block[axis]) + Block<D>::width + 1);
    };
    return end(0) > outlet.from && end(D - 1) > outlet.level;
}

// The particles of block `slot` that have passed the outlet, ascending.
template <int D, class Real>
std::vector<std::size_t> passed(const Outlet& outlet, const Grid<D, Real>& grid,
                                const Particles<D, Real>& particles, std::size_t slot) {
    std::vector<std::size_t> gone;
    const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
    if (!reaches<D>(grid.layout, outlet, block)) return gone;
    for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
        const Vector<D, double> at = global_position(grid.layout, block, particles, p);
        if (at[0] > outlet.from && at[D - 1] > outlet.level) gone.push_back(p);
    }
    return gone;
}

}  // namespace

template <int D, class Real>
void drain(const Parameters<D>& parameters, const Grid<D, Real>& grid,
           std::vector<Particles<D, Real>>& bodies, Outflow<D>& outflow) {
    const Outlet& outlet = parameters.boundaries.outlet;
    if (!outlet.exists()) return;
    for (auto& particles : bodies) {
        if (particles.material != Material::water) continue;
        std::vector<std::size_t> gone;
        for (std::size_t slot = 0; slot < grid.particle_blocks.size(); ++slot) {
            const auto of_block = passed(outlet, grid, particles, slot);
            gone.insert(gone.end(), of_block.begin(), of_block.end());
        }
        take_out(gone, parameters, grid, particles, outflow);
    }
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                \
    template void drain(const Parameters<D>&, const Grid<D, Real>&, std::vector<Particles<D, Real>>&, \
                        Outflow<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
