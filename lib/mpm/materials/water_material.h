// Water in the table of materials (mpm/materials/materials.h).
//
// The step of a particle, with crowding ē (mpm/step/crowding.h), rate r and the limits below:
//
//     J ← J (1 + Δt tr C) + r (1/(1 + ē) − J)
//     ∂(m v)/∂x · Δx  +=  (4 Δt'/Δx) V0 J p(J) I           the force of τ = −J p I, mpm/particles/transfer.h
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "mpm/base/interval.h"
#include "mpm/materials/material.h"
#include "mpm/materials/water.h"
#include "mpm/particles/particles.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {

// Max. rate r per step at which the scheme `density` draws J to the particle's space (mpm/step/crowding.h).
inline constexpr double max_crowding_rate = 0.02;
// Limits of the scheme `density`: in one step J shrinks by at most a fifth, and it never exceeds 2. Only a
// lone particle in a splash or in a film on a wall reaches these limits. No other particle moves its nodes,
// so it keeps its divergence, and J would go to 0 or to infinity. Later, J is drawn to the particle's space
// again.
inline constexpr double min_growth = -0.2;  // ΔJ/J
inline constexpr double max_j = 1.0;        // J − 1
inline constexpr double unbounded = 1e30;   // stands for no limit on J or ΔJ/J

// Whether J is drawn to the space that a particle has on the grid.
inline bool keeps_to_room(const WaterModel& water) { return water.scheme == WaterScheme::density; }

// The rate r = min(Δt/√(Δx/g), max_crowding_rate) of a step of dt (s), with gravity g (m/s²) and cells of
// cell_size (m). It is 0 for the scheme `paper` and without gravity.
inline double crowding_rate(const WaterModel& water, double gravity, double cell_size, double dt) {
    if (!keeps_to_room(water)) return 0.0;
    return std::min(dt * std::sqrt(gravity / cell_size), max_crowding_rate);
}

// The source of water's pressure, here each particle's own J. A scheme that keeps pressure on cells replaces
// this as the argument of WaterMaterial::KernelOf; nothing else in a step uses p(J).
struct PressureOfParticles {
    template <class Real>
    void operator()(const Column<Real>& j, const WaterModel& water, Column<Real>& pressure) const {
        water_pressure(j, water, pressure);
    }
};

template <int D, class Real>
struct WaterMaterial {
    static constexpr Material material = Material::water;
    using Model = WaterModel;

    template <class Parameters>
    static const WaterModel& model(const Parameters& parameters) {
        return parameters.water;
    }

    // Makes the column of `count` particles without pressure.
    static void make_columns(const WaterModel&, std::size_t count, Particles<D, Real>& particles) {
        particles.j.assign(count, Real(0));
    }

    // The max. speed of sound, that of the most compressed water, m/s.
    static double sound_speed(const WaterModel& water, const Findings& findings) {
        return water.sound_speed * water_sound_speed_ratio(findings.min_j, water.exponent);
    }

    // The elastic energy of the particles first … first + count − 1, J.
    static void stored_energy(const WaterModel& water, const Particles<D, Real>& particles, std::size_t first,
                              int count, Column<double>& energy) {
        Column<double> j{};
        for (int p = 0; p < count; ++p)
            j[p] = static_cast<double>(particles.j[first + static_cast<std::size_t>(p)]);
        water_energy(j, water, energy);
        for (int p = 0; p < batch_size; ++p) energy[p] *= particles.volume;
    }

    // What is wrong with the state of particle p, whose numbers are finite; null if nothing is.
    static const char* complaint(const Particles<D, Real>& particles, std::size_t p, bool /*may_fail*/) {
        if (particles.j[p] > Real(-1)) return nullptr;
        return " was squeezed to no volume; use a smaller simulate.cfl or a higher water.sound_speed";
    }

    // The constants of one step, the same for all blocks.
    struct Step {
        const WaterModel& water;
        Real cells_per_speed;  // Δt/Δx
        Real min_growth;       // ΔJ/J
        Real max_j;            // J − 1
        Real crowding_rate;    // r
        double impulse;        // 4 Δt'/Δx, s/m: gradient of momentum per stress and volume

        Step(const WaterModel& model, double gravity, double cell_size, const Interval& interval)
            : water(model),
              cells_per_speed(static_cast<Real>(interval.dt / cell_size)),
              min_growth(static_cast<Real>(keeps_to_room(model) ? mpm::min_growth : -unbounded)),
              max_j(static_cast<Real>(keeps_to_room(model) ? mpm::max_j : unbounded)),
              crowding_rate(static_cast<Real>(mpm::crowding_rate(model, gravity, cell_size, interval.dt))),
              impulse(4.0 * interval.force_dt() / cell_size) {}

        // Whether the kernel reads ē from the tile's crowding lane.
        bool reads_crowding() const { return crowding_rate > Real(0); }
    };

    template <class Pressure>
    struct KernelOf {
        Particles<D, Real>& particles;
        const Step& step;
        Pressure pressure_rule{};
        Column<Real> min_j{};  // per lane, because a minimum over lanes would not vectorise

        Findings findings() const {
            return {.min_j = static_cast<double>(
                        *std::min_element(std::begin(min_j.value), std::end(min_j.value)))};
        }

        // change = r (1/(1 + ē) − J), or 0 where ē is infinite, which means that it is unknown.
        void volume_correction(const Column<Real>& crowding, const Column<Real>& j,
                               Column<Real>& change) const {
            for (int p = 0; p < batch_size; ++p) {
                const bool known = crowding[p] < std::numeric_limits<Real>::max();
                const Real e = known ? crowding[p] : Real(0);
                change[p] = known ? step.crowding_rate * (-e / (Real(1) + e) - j[p]) : Real(0);
            }
        }

        // Advances J of the particles first … first + count − 1 and turns the batch's velocities and
        // gradients into momenta and their gradients.
        void update(std::size_t first, int count, TransferBatch<D, Real>& batch) {
            Column<Real> j, pressure, correction{};
            load_column(particles.j.data() + first, count, j);
            if (step.reads_crowding()) volume_correction(batch.scalar, j, correction);
            for (int p = 0; p < batch_size; ++p) {
                Real trace = batch.gradient[0][p];
                for (int axis = 1; axis < D; ++axis) trace += batch.gradient[axis * (D + 1)][p];
                const Real growth = std::max(step.cells_per_speed * trace, step.min_growth);
                j[p] = std::min(j[p] + (Real(1) + j[p]) * growth + correction[p], step.max_j);
            }
            store_column(j, count, particles.j.data() + first);
            for (int p = 0; p < batch_size; ++p) min_j[p] = std::min(min_j[p], j[p]);
            pressure_rule(j, step.water, pressure);
            velocity_to_momentum(static_cast<Real>(particles.mass), batch);
            const auto factor = static_cast<Real>(step.impulse * particles.volume);
            for (int axis = 0; axis < D; ++axis) {
                Column<Real>& g = batch.gradient[axis * (D + 1)];
                for (int p = 0; p < batch_size; ++p) g[p] += factor * (Real(1) + j[p]) * pressure[p];
            }
        }
    };
    using Kernel = KernelOf<PressureOfParticles>;
};

}  // namespace tidewater::mpm
