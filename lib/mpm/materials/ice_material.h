// Ice in the table of materials (mpm/materials/materials.h).
//
// The step of a particle, with the symbols of mpm/materials/ice.h:
//
//     b ← (I + Δt C) b (I + Δt C)ᵀ,  then the return to the yield surface if ice may fracture
//     ∂(m v)/∂x · Δx  −=  (4 Δt'/Δx) V0 τ                   mpm/particles/transfer.h
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "mpm/base/interval.h"
#include "mpm/materials/ice.h"
#include "mpm/materials/ice_lane.h"
#include "mpm/materials/ice_yield.h"
#include "mpm/materials/material.h"
#include "mpm/particles/particles.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {

template <int D, class Real>
struct IceMaterial {
    static constexpr Material material = Material::ice;
    using Model = IceModel;

    template <class Parameters>
    static const IceModel& model(const Parameters& parameters) {
        return parameters.ice;
    }

    // Makes the columns of `count` intact particles without stress.
    static void make_columns(const IceModel& ice, std::size_t count, Particles<D, Real>& particles) {
        for (auto& column : particles.strain) column.assign(count, Real(0));
        if (!ice.fracture) return;
        particles.alpha.assign(count, static_cast<Real>(ice.initial_alpha(D)));
        particles.failure_time.assign(count, std::numeric_limits<Real>::infinity());
    }

    // The speed of P waves, m/s.
    static double sound_speed(const IceModel& ice, const Findings&) { return ice.wave_speed(D); }

    // The elastic energy of the particles first … first + count − 1, J.
    static void stored_energy(const IceModel& ice, const Particles<D, Real>& particles, std::size_t first,
                              int count, Column<double>& energy) {
        Column<double> strain[symmetric_size<D>]{};
        for (std::size_t c = 0; c < particles.strain.size(); ++c) {
            for (int p = 0; p < count; ++p)
                strain[c][p] = static_cast<double>(particles.strain[c][first + static_cast<std::size_t>(p)]);
        }
        ice_energy<D>(ice, strain, energy);
        for (int p = 0; p < batch_size; ++p) energy[p] *= particles.volume;
    }

    // What is wrong with the state of particle p, whose numbers are finite; null if nothing is. For ice that
    // may fail, any strain is usable.
    static const char* complaint(const Particles<D, Real>& particles, std::size_t p, bool may_fail) {
        if (may_fail || !beyond_elastic(particles, p)) return nullptr;
        return " is strained beyond what elastic ice can bear, as ice is without the effect \"fracture\" and "
               "while it settles; lower its load or use a smaller simulate.cfl";
    }

    // Whether ice_stress finds the particle unusable.
    static bool beyond_elastic(const Particles<D, Real>& particles, std::size_t p) {
        constexpr int count = symmetric_size<D>;
        Column<Real> strain[count]{}, stress[count];
        for (std::size_t c = 0; c < count; ++c) strain[c][0] = particles.strain[c][p];
        return ice_stress<D, Real>(IceConstants<D, Real>(IceModel{}), strain, lanes, stress) & ice_unusable;
    }

    // The constants of one step, the same for all blocks.
    struct Step {
        IceConstants<D, Real> ice;
        Real cells_per_speed;  // Δt/Δx
        double impulse;        // 4 Δt'/Δx, s/m: gradient of momentum per stress and volume
        bool fracture;         // ice may fail in this step
        Real end;              // s, end of the step

        Step(const IceModel& model, double /*gravity*/, double cell_size, const Interval& interval)
            : ice(model),
              cells_per_speed(static_cast<Real>(interval.dt / cell_size)),
              impulse(4.0 * interval.force_dt() / cell_size),
              fracture(model.fracture && !interval.settling),
              end(static_cast<Real>(interval.end())) {}

        bool reads_crowding() const { return false; }
    };

    struct Kernel {
        Particles<D, Real>& particles;
        const Step& step;
        unsigned state = 0;  // IceState bits

        Findings findings() const { return {.unusable = (state & ice_unusable) != 0}; }

        // Advances the strain of the particles first … first + count − 1 and turns the batch's velocities and
        // gradients into momenta and their gradients.
        void update(std::size_t first, int count, TransferBatch<D, Real>& batch) {
            const int whole = padded(count);
            Column<Real> increment[D * D], strain[symmetric_size<D>], alpha, stress[symmetric_size<D>];
            for (int c = 0; c < D * D; ++c) {
                for (int p = 0; p < batch_size; ++p)
                    increment[c][p] = step.cells_per_speed * batch.gradient[c][p];
            }
            for (int c = 0; c < symmetric_size<D>; ++c) load_column(strain_from(c, first), count, strain[c]);
            advance_strain<D, Real>(increment, whole, strain);
            if (step.fracture) {
                load_column(particles.alpha.data() + first, count, alpha);
                const unsigned batch_state =
                    return_to_yield<D, Real>(step.ice, whole, strain, &alpha, stress);
                if (batch_state & ice_yielded) {
                    store_column(alpha, count, particles.alpha.data() + first);
                    note_failures(alpha, count, particles.failure_time.data() + first);
                }
                state |= batch_state;
            } else {
                state |= ice_stress<D, Real>(step.ice, strain, whole, stress);
            }
            for (int c = 0; c < symmetric_size<D>; ++c) store_column(strain[c], count, strain_from(c, first));
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

        // Sets the failure time of particles that have just failed.
        void note_failures(const Column<Real>& alpha, int count, Real* failure_time) const {
            for (int p = 0; p < count; ++p) {
                if (alpha[p] >= Real(0)) failure_time[p] = std::min(failure_time[p], step.end);
            }
        }

        Real* strain_from(int c, std::size_t first) {
            return particles.strain[static_cast<std::size_t>(c)].data() + first;
        }
    };
};

}  // namespace tidewater::mpm
