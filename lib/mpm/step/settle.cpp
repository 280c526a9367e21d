#include "mpm/step/settle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mpm/base/instantiate.h"
#include "mpm/particles/motion.h"
#include "mpm/step/step.h"

namespace tidewater::mpm {
namespace {

constexpr int quiet_peaks = 3;  // in a row; a single one may be the minimum of a beat

template <int D, class Real>
bool has_ice(const Simulation<D, Real>& s) {
    for (const auto& particles : s.bodies) {
        if (particles.material == Material::ice) return true;
    }
    return false;
}

// The particles that are to come to rest: those of ice, or all without ice.
struct Motion {
    double mass = 0.0;    // kg
    double energy = 0.0;  // kinetic, J
};

template <int D, class Real>
Motion motion_of(const Simulation<D, Real>& s) {
    const bool all = !has_ice(s);
    Motion sum;
    for (const auto& particles : s.bodies) {
        if (!all && particles.material != Material::ice) continue;
        std::vector<double> of_block(s.grid.particle_blocks.size(), 0.0);
        for_each_motion(
            s.grid, particles,
            [&](std::size_t slot, const Index<D>&, std::size_t, const Vector<D, Real>& v,
                const Matrix<D, Real>&) { of_block[slot] += v.template cast<double>().squaredNorm(); });
        for (const double squares : of_block) sum.energy += 0.5 * particles.mass * squares;
        sum.mass += particles.mass * static_cast<double>(particles.size());
    }
    return sum;
}

template <int D, class Real>
void stop_everything(Simulation<D, Real>& s) {
    for (auto& node : s.grid.nodes) node.template head<3>().setZero();
    s.speeds.particle = 0.0;
    s.speeds.signal.sound = s.speeds.sound;
    s.speeds.signal.motion = 0.0;
    std::ranges::fill(s.near_speed, 0.0);
}

template <int D, class Real>
void begin_time(Simulation<D, Real>& s) {
    s.settling.going = false;
    s.step = 0;
    s.dt = 0.0;
    s.accounts = {};
    for (RigidBody& body : s.rigid) {
        body.water_impulse.setZero();
        body.water_angular_impulse.setZero();
        body.contact_impulse.setZero();
    }
}

}  // namespace

template <int D, class Real>
void begin_settling(Simulation<D, Real>& s) {
    s.settling = {.going = true, .stress = std::numeric_limits<double>::infinity()};
}

template <int D, class Real>
bool settle_step(Simulation<D, Real>& s, double tolerance) {
    Settling& settling = s.settling;
    settling.time += s.dt;
    advance(s, stable_time_step(s));
    s.time = 0.0;
    const Motion motion = motion_of(s);
    const bool falls = motion.energy < settling.energy || (motion.energy == 0.0 && settling.time > 0.0);
    if (!falls) {
        settling.energy = motion.energy;
        return false;
    }
    const bool ice = has_ice(s);
    const double speed = std::sqrt(2.0 * settling.energy / motion.mass);
    const double impedance = ice ? s.parameters.ice.density * s.parameters.ice.wave_speed(D)
                                 : s.parameters.water.density * s.parameters.water.sound_speed;
    settling.stress = impedance * speed;
    settling.quiet = settling.stress <= tolerance ? settling.quiet + 1 : 0;
    settling.energy = 0.0;
    stop_everything(s);
    if (settling.quiet < quiet_peaks) return false;
    begin_time(s);
    return true;
}

#define TIDEWATER_INSTANTIATE(D, Real)                  \
    template void begin_settling(Simulation<D, Real>&); \
    template bool settle_step(Simulation<D, Real>&, double);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
