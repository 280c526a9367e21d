#include "tally.h"

#include "mpm/step/time_step.h"

namespace tidewater {

template <int D, class Real>
TimeStepLimit time_step_limit(const mpm::Simulation<D, Real>& s) {
    const mpm::Signal& signal = s.speeds.signal;
    const double courant = s.parameters.cfl * s.grid.layout.cell_size / signal.speed();
    if (signal.speed() == 0.0 || mpm::stable_time_step(s) < courant) return TimeStepLimit::falling;
    if (signal.sound < signal.motion) return TimeStepLimit::motion;
    return signal.material == Material::ice ? TimeStepLimit::sound_in_ice : TimeStepLimit::sound_in_water;
}

template TimeStepLimit time_step_limit(const mpm::Simulation<2, float>&);
template TimeStepLimit time_step_limit(const mpm::Simulation<2, double>&);
template TimeStepLimit time_step_limit(const mpm::Simulation<3, float>&);
template TimeStepLimit time_step_limit(const mpm::Simulation<3, double>&);

}  // namespace tidewater
