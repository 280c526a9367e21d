#include "mpm/step/pass.h"

#include <algorithm>

#include "mpm/base/instantiate.h"
#include "mpm/particles/motion.h"
#include "mpm/particles/transfer_batch.h"
#include "mpm/step/crowding.h"
#include "mpm/step/failures.h"

namespace tidewater::mpm {
namespace {

// Passes over the particles of a block, one batch after the other, and returns their max. |v| along an axis.
// kernel.update(first, count, batch) advances strains and turns the batch's velocities and gradients into
// momenta and their gradients.
template <int D, class Real, class Kernel>
double pass_particles(const PassContext<D, Real>& context, std::size_t slot, const Node<Real>* from,
                      Strips<D, Real>& to, Particles<D, Real>& particles, Kernel& kernel) {
    TransferBatch<D, Real> batch;
    Column<Real> motion{};
    const auto mass = static_cast<Real>(particles.mass);
    for_each_batch(particles, slot, [&](std::size_t first, int count, Column<Stored<Real>>* position) {
        locate<D, Real>(position, batch.stencil);
        gather_batch<D, Real>(from->data(), batch);
        for (std::size_t axis = 0; axis < D; ++axis) {
            take_max_size(batch.vector[axis], motion);
            advance_positions(batch.vector[axis], context.cells_per_speed, context.shift, position[axis]);
            store_column(position[axis], count, particles.position[axis].data() + first);
        }
        kernel.update(first, count, batch);
        locate<D, Real>(position, batch.stencil);
        scatter_batch<D, Real>(mass, count, batch, to);
    });
    return static_cast<double>(*std::max_element(motion.value, motion.value + batch_size));
}

}  // namespace

template <int D, class Real>
PassContext<D, Real>::PassContext(const Interval& interval, const Parameters<D>& of_run, double cell_size)
    : cells_per_speed(static_cast<Real>(interval.dt / cell_size)),
      shift(static_cast<Real>(rounding_shift(interval.step))),
      materials(of_run, cell_size, interval),
      parameters(of_run) {}

template <int D, class Real>
PassResult<D> pass_over_block(const PassContext<D, Real>& context, std::size_t slot, const Node<Real>* from,
                              Grid<D, Real>& grid, std::vector<Particles<D, Real>>& bodies) {
    Strips<D, Real> strips{};
    PassResult<D> result;
    for (auto& particles : bodies) {
        if (particles.begin[slot] == particles.begin[slot + 1]) continue;
        with_material<D, Real>(particles.material, [&]<class M>(std::type_identity<M>) {
            typename M::Kernel kernel{particles, context.materials.template step<M>()};
            const double motion = pass_particles(context, slot, from, strips, particles, kernel);
            result.motion = std::max(result.motion, motion);
            result.findings.add(kernel.findings());
            const double sound = M::sound_speed(M::model(context.parameters), kernel.findings());
            if (sound > result.signal.sound)
                result.signal = {.sound = sound, .motion = 0.0, .material = M::material};
        });
    }
    Node<Real>* to = grid.tile(slot);
    sum_strips<D, Real>(strips, to->data());
    std::fill(to + Block<D>::tile_nodes, to + Block<D>::tile_size, Node<Real>::Zero());
    const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
    result.impulse = fold<D, Real>(grid.layout, block, Parity::velocity, to);
    return result;
}

template <int D, class Real>
PassFindings pass_over_blocks(const Interval& interval, const Parameters<D>& parameters, const Slots& slots,
                              const std::vector<RigidBody>& rigid,
                              const std::vector<std::uint8_t>& unknown_fill, Grid<D, Real>& grid,
                              std::vector<Particles<D, Real>>& bodies, std::vector<double>& drift,
                              Vector<D, double>& wall_impulse) {
    const PassContext<D, Real> context(interval, parameters, grid.layout.cell_size);
    const bool crowding = context.materials.reads_crowding();
    std::vector<PassResult<D>> results(slots.size());
    parallel_for(slots.size(), [&](std::size_t n) {
        const std::size_t slot = slots[n];
        alignas(64) Tile<D, Real> tile;
        load_velocities(grid, slot, tile.data());
        if (crowding && has_water(bodies, slot))
            load_crowding(parameters.water.density, grid, rigid, unknown_fill, slot, tile.data());
        results[n] = pass_over_block(context, slot, tile.data(), grid, bodies);
    });
    PassFindings findings;
    findings.of_block.resize(grid.particle_blocks.size());
    for (std::size_t n = 0; n < results.size(); ++n) {
        findings.all.add(results[n].findings);
        findings.of_block[slots[n]] = results[n].signal;
        drift[slots[n]] += results[n].motion * interval.dt / grid.layout.cell_size;
        wall_impulse += results[n].impulse;
    }
    if (findings.all.unusable || !(findings.all.min_j > -1.0))
        fail_at_bad_particle(interval, parameters, bodies);
    return findings;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                      \
    template struct PassContext<D, Real>;                                                                   \
    template PassResult<D> pass_over_block(const PassContext<D, Real>&, std::size_t, const Node<Real>*,     \
                                           Grid<D, Real>&, std::vector<Particles<D, Real>>&);               \
    template PassFindings pass_over_blocks(const Interval&, const Parameters<D>&, const Slots&,             \
                                           const std::vector<RigidBody>&, const std::vector<std::uint8_t>&, \
                                           Grid<D, Real>&, std::vector<Particles<D, Real>>&,                \
                                           std::vector<double>&, Vector<D, double>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
