#include "mpm/step/particle_pass.h"

#include <algorithm>
#include <limits>

#include "mpm/step/crowding.h"
#include "mpm/materials/ice_lane.h"
#include "mpm/particles/motion.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {
namespace {

// One batch after the other; material.update(first, count, batch) advances strains and turns the batch's
// velocities and gradients into momenta and their gradients.
template <int D, class Real, class MaterialUpdate>
void pass_particles(const PassContext<D, Real>& step, std::size_t slot, const Node<Real>* from,
                    Strips<D, Real>& to, Particles<D, Real>& particles, MaterialUpdate& material) {
    TransferBatch<D, Real> batch;
    const auto mass = static_cast<Real>(particles.mass);
    for_each_batch(particles, slot, [&](std::size_t first, int count, Column<Stored<Real>>* position) {
        locate<D, Real>(position, batch.stencil);
        gather_batch<D, Real>(from->data(), batch);
        for (std::size_t axis = 0; axis < D; ++axis) {
            advance_positions(batch.vector[axis], step.cells_per_speed, step.shift, position[axis]);
            store_column(position[axis], count, particles.position[axis].data() + first);
        }
        material.update(first, count, batch);
        locate<D, Real>(position, batch.stencil);
        scatter_batch<D, Real>(mass, count, batch, to);
    });
}

// J ← J (1 + Δt tr C) + r (1/(1 + ē) − J), limited as mpm/step/crowding.h says, and τ = −J p(J) I.
template <int D, class Real>
struct WaterUpdate {
    Particles<D, Real>& particles;
    const WaterModel& water;
    const PassContext<D, Real>& step;
    Column<Real> least{};  // lane by lane, since a minimum over lanes would not vectorise

    double least_j() const {
        return static_cast<double>(*std::min_element(std::begin(least.value), std::end(least.value)));
    }

    // r (1/(1 + ē) − J); 0 where ē is not known, that is infinite.
    void make_good_crowding(const Column<Real>& crowding, const Column<Real>& j, Column<Real>& change) const {
        for (int p = 0; p < batch_size; ++p) {
            const bool known = crowding[p] < std::numeric_limits<Real>::max();
            const Real e = known ? crowding[p] : Real(0);
            change[p] = known ? step.crowding_rate * (-e / (Real(1) + e) - j[p]) : Real(0);
        }
    }

    void update(std::size_t first, int count, TransferBatch<D, Real>& batch) {
        Column<Real> j, pressure, made_good{};
        load_column(particles.j.data() + first, count, j);
        if (step.crowding_rate > Real(0)) make_good_crowding(batch.scalar, j, made_good);
        for (int p = 0; p < batch_size; ++p) {
            Real trace = batch.gradient[0][p];
            for (int axis = 1; axis < D; ++axis) trace += batch.gradient[axis * (D + 1)][p];
            const Real growth = std::max(step.cells_per_speed * trace, step.least_growth);
            j[p] = std::min(j[p] + (Real(1) + j[p]) * growth + made_good[p], step.greatest_j);
        }
        store_column(j, count, particles.j.data() + first);
        for (int p = 0; p < batch_size; ++p) least[p] = std::min(least[p], j[p]);
        water_pressure(j, water, pressure);
        velocity_to_momentum(static_cast<Real>(particles.mass), batch);
        const auto factor = static_cast<Real>(step.impulse * particles.volume);
        for (int axis = 0; axis < D; ++axis) {
            Column<Real>& g = batch.gradient[axis * (D + 1)];
            for (int p = 0; p < batch_size; ++p) g[p] += factor * (Real(1) + j[p]) * pressure[p];
        }
    }
};

// Strain ← (I + Δt C) b (I + Δt C)ᵀ − I, back to the yield surface where ice may fracture, and its stress.
template <int D, class Real>
struct IceUpdate {
    Particles<D, Real>& particles;
    const PassContext<D, Real>& step;
    unsigned state = 0;

    void update(std::size_t first, int count, TransferBatch<D, Real>& batch) {
        const int whole = padded(count);
        Column<Real> increment[D * D], strain[symmetric_size<D>], alpha, stress[symmetric_size<D>];
        for (int c = 0; c < D * D; ++c) {
            for (int p = 0; p < batch_size; ++p)
                increment[c][p] = step.cells_per_speed * batch.gradient[c][p];
        }
        for (int c = 0; c < symmetric_size<D>; ++c) load_column(strain_at(c) + first, count, strain[c]);
        advance_strain<D, Real>(increment, whole, strain);
        if (step.fracture) {
            load_column(particles.alpha.data() + first, count, alpha);
            const unsigned batch_state = return_to_yield<D, Real>(step.ice, whole, strain, &alpha, stress);
            if (batch_state & ice_yielded) {
                store_column(alpha, count, particles.alpha.data() + first);
                note_failures(alpha, count, particles.failure_time.data() + first);
            }
            state |= batch_state;
        } else {
            state |= ice_stress<D, Real>(step.ice, strain, whole, stress);
        }
        for (int c = 0; c < symmetric_size<D>; ++c) store_column(strain[c], count, strain_at(c) + first);
        velocity_to_momentum(static_cast<Real>(particles.mass), batch);
        const auto factor = static_cast<Real>(step.impulse * particles.volume);
        for (int i = 0; i < D; ++i) {
            for (int k = 0; k < D; ++k) {
                const Column<Real>& tau = stress[ice_lane::column<D>(i, k)];
                Column<Real>& g = batch.gradient[i * D + k];
                for (int p = 0; p < whole; ++p) g[p] -= factor * tau[p];
            }
        }
    }

    void note_failures(const Column<Real>& alpha, int count, Real* failure_time) const {
        for (int p = 0; p < count; ++p) {
            if (alpha[p] >= Real(0)) failure_time[p] = std::min(failure_time[p], step.time);
        }
    }

    Real* strain_at(int c) { return particles.strain[static_cast<std::size_t>(c)].data(); }
};

}  // namespace

template <int D, class Real>
PassContext<D, Real>::PassContext(const Simulation<D, Real>& s, double next_dt)
    : cells_per_speed(static_cast<Real>(s.dt / s.grid.layout.cell_size)),
      shift(static_cast<Real>(rounding_shift(s.step))),
      least_growth(static_cast<Real>(keeps_to_room(s.parameters.water) ? mpm::least_growth : -1e30)),
      greatest_j(static_cast<Real>(keeps_to_room(s.parameters.water) ? mpm::greatest_j : 1e30)),
      crowding_rate(static_cast<Real>(mpm::crowding_rate(s.parameters, s.grid.layout.cell_size, s.dt))),
      impulse(4.0 * next_dt / s.grid.layout.cell_size),
      ice(s.parameters.ice),
      fracture(s.parameters.ice.fracture && !s.settling.going),
      time(static_cast<Real>(s.time + s.dt)) {}

template <int D, class Real>
PassResult<D> pass_over_block(const PassContext<D, Real>& step, std::size_t slot, const Node<Real>* from,
                              Simulation<D, Real>& s) {
    Strips<D, Real> strips{};
    PassResult<D> result;
    for (auto& particles : s.bodies) {
        if (particles.begin[slot] == particles.begin[slot + 1]) continue;
        switch (particles.material) {
            case Material::water: {
                WaterUpdate<D, Real> update{particles, s.parameters.water, step};
                pass_particles(step, slot, from, strips, particles, update);
                result.least_j = std::min(result.least_j, update.least_j());
                break;
            }
            case Material::ice: {
                IceUpdate<D, Real> update{particles, step};
                pass_particles(step, slot, from, strips, particles, update);
                result.unusable = result.unusable || (update.state & ice_unusable);
                break;
            }
            case Material::rigid:  // no particles
                break;
        }
    }
    Node<Real>* to = s.grid.tile(slot);
    sum_strips<D, Real>(strips, to->data());
    std::fill(to + Block<D>::tile_nodes, to + Block<D>::tile_size, Node<Real>::Zero());
    const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
    result.impulse = fold<D, Real>(s.grid.layout, block, Parity::velocity, to);
    return result;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                  \
    template struct PassContext<D, Real>;                                                               \
    template PassResult<D> pass_over_block(const PassContext<D, Real>&, std::size_t, const Node<Real>*, \
                                           Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
