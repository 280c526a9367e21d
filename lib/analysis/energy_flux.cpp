#include "analysis/energy_flux.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "analysis/dispersion.h"

namespace tidewater::analysis {

double spectral_energy_flux(const Spectrum& spectrum, const WaterColumn& water) {
    assert(water.depth > 0.0 && water.density > 0.0 && water.gravity > 0.0);
    if (spectrum.frequency.empty()) return none;
    double sum = 0.0;
    for (std::size_t k = 0; k < spectrum.frequency.size(); ++k) {
        const double frequency = 2.0 * std::numbers::pi * spectrum.frequency[k];
        sum +=
            spectrum.density[k] * spectrum.width(k) * group_celerity(frequency, water.depth, water.gravity);
    }
    return water.density * water.gravity * sum;
}

double long_wave_energy(std::span<const double> time, std::span<const double> elevation,
                        const WaterColumn& water) {
    assert(time.size() == elevation.size());
    assert(water.depth > 0.0 && water.density > 0.0 && water.gravity > 0.0);
    const auto flux = [&](double eta) {
        const double celerity = std::sqrt(water.gravity * std::max(water.depth + eta, 0.0));
        return water.density * water.gravity * eta * eta * celerity;
    };
    double energy = none;
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (std::isnan(elevation[i - 1]) || std::isnan(elevation[i])) continue;
        const double passed = 0.5 * (flux(elevation[i - 1]) + flux(elevation[i])) * (time[i] - time[i - 1]);
        energy = std::isnan(energy) ? passed : energy + passed;
    }
    return energy;
}

}  // namespace tidewater::analysis
