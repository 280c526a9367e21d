#include "tally.h"

#include "mpm/step/time_step.h"

namespace tidewater {

template <int D, class Real>
TimeStepLimit time_step_limit(const mpm::Simulation<D, Real>& s) {
    const double sound = s.speeds.sound, motion = s.speeds.particle;
    const double courant = s.parameters.cfl * s.grid.layout.cell_size / (sound + motion);
    if (sound + motion == 0.0 || mpm::stable_time_step(s) < courant) return TimeStepLimit::falling;
    if (sound < motion) return TimeStepLimit::motion;
    // Squeezed water is faster than it was at the start, ice always as fast.
    const bool ice = std::ranges::any_of(
        s.bodies, [](const auto& particles) { return particles.material == Material::ice; });
    return ice && sound <= s.parameters.ice.wave_speed(D) ? TimeStepLimit::sound_in_ice
                                                          : TimeStepLimit::sound_in_water;
}

template TimeStepLimit time_step_limit(const mpm::Simulation<2, float>&);
template TimeStepLimit time_step_limit(const mpm::Simulation<2, double>&);
template TimeStepLimit time_step_limit(const mpm::Simulation<3, float>&);
template TimeStepLimit time_step_limit(const mpm::Simulation<3, double>&);

}  // namespace tidewater
