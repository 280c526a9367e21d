#include "mpm/state/ledger.h"

#include <iterator>
#include <numeric>

#include "mpm/base/instantiate.h"
#include "mpm/bodies/lift.h"
#include "mpm/materials/materials.h"
#include "mpm/particles/motion.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {
namespace {

template <int D>
void add(Ledger<D>& to, const Ledger<D>& from) {
    to.mass += from.mass;
    to.momentum += from.momentum;
    to.kinetic += from.kinetic;
    to.gravitational += from.gravitational;
    to.elastic += from.elastic;
}

}  // namespace

template <int D, class Real>
Ledger<D> ledger_of(const Parameters<D>& parameters, const Layout<D>& layout,
                    const Particles<D, Real>& particles, const Index<D>& block, std::size_t first,
                    std::size_t end, const Tile<D, Real>& tile) {
    TransferBatch<D, Real> batch;
    Column<double> elastic{};
    // Sums over batches of v, of |v|² + |Δx C|²/4 (m²/s²), of heights in cells above the block and of elastic
    // energies, lane by lane because sums over lanes would not vectorise.
    Column<double> velocity[D]{}, squares{}, height{}, energy{};
    Ledger<D> sum;
    for_each_batch(particles, first, end, [&](std::size_t p0, int count, const auto* position) {
        locate<D, Real>(position, batch.stencil);
        gather_batch<D, Real>(tile.data()->data(), batch);
        with_material<D, Real>(particles.material, [&]<class M>(std::type_identity<M>) {
            M::stored_energy(M::model(parameters), particles, p0, count, elastic);
        });
        for (int axis = 0; axis < D; ++axis) {
            for (int p = 0; p < count; ++p) {
                const auto v = static_cast<double>(batch.vector[axis][p]);
                velocity[axis][p] += v;
                squares[p] += v * v;
            }
        }
        for (const auto& column : batch.gradient) {
            for (int p = 0; p < count; ++p) {
                const auto g = static_cast<double>(column[p]);
                squares[p] += 0.25 * g * g;
            }
        }
        for (int p = 0; p < count; ++p) {
            height[p] += cells_of(position[D - 1][p]);
            energy[p] += elastic[p];
        }
    });
    const auto total = [](const Column<double>& of) {
        return std::accumulate(std::begin(of.value), std::end(of.value), 0.0);
    };
    const auto count = static_cast<double>(end - first);
    const double bottom = layout.first_node(block[D - 1]);
    sum.mass = particles.mass * count;
    for (int axis = 0; axis < D; ++axis) sum.momentum[axis] = particles.mass * total(velocity[axis]);
    sum.kinetic = 0.5 * particles.mass * total(squares);
    sum.elastic = total(energy);
    sum.gravitational =
        particles.mass * parameters.gravity * layout.cell_size * (count * bottom + total(height));
    return sum;
}

template <int D, class Real>
Ledger<D> take_ledger(const Simulation<D, Real>& s) {
    std::vector<Ledger<D>> of_block(s.grid.particle_blocks.size());
    for (const auto& particles : s.bodies) {
        parallel_for(of_block.size(), [&](std::size_t slot) {
            if (particles.begin[slot] == particles.begin[slot + 1]) return;
            const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
            alignas(64) Tile<D, Real> tile;
            load_velocities(s.grid, slot, tile.data());
            add(of_block[slot], ledger_of(s.parameters, s.grid.layout, particles, block,
                                          particles.begin[slot], particles.begin[slot + 1], tile));
        });
    }
    Ledger<D> total;
    for (const auto& ledger : of_block) add(total, ledger);
    for (const RigidBody& body : s.rigid) {
        total.mass += body.mass;
        total.gravitational +=
            body.mass * s.parameters.gravity * body.center_in_box(s.grid.layout.cell_size)[2];
        total.momentum += body.mass * drop<D>(body.velocity);
        total.kinetic += kinetic_energy(body);
    }
    return total;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                              \
    template Ledger<D> ledger_of(const Parameters<D>&, const Layout<D>&, const Particles<D, Real>&, \
                                 const Index<D>&, std::size_t, std::size_t, const Tile<D, Real>&);  \
    template Ledger<D> take_ledger(const Simulation<D, Real>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
