// What is said of a gauge's whole record: its waves one by one, its spectrum, and the energy that passed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/energy_flux.h"
#include "analysis/spectrum.h"
#include "analysis/wave.h"
#include "analysis/wave_statistics.h"
#include "core/provenance.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

struct GaugeRecord;
struct Waves;

// All of the record smoothed as for GaugeWave (analysis/wave.h), and from its level of rest; in a scene that
// starts as a wave, from its mean. Waves are those of the whole record, with what comes back from walls, as
// of a gauge in nature. The spectrum is of what follows the arrival. Energies are of the time until a
// reflection may be back; in a scene with a sponge or an outlet none comes.
struct GaugeStatistics {
    double depth = analysis::none;  // D, still, at the gauge, m
    analysis::WaveStatistics waves;
    analysis::Spectrum spectrum;
    double energy_flux = analysis::none;  // P, W/m, from the spectrum of that time if it can be trusted
    double energy = analysis::none;       // W, J/m, of long waves
    std::string doubt;                    // why some of it is missing or not to be trusted; empty: nothing is
};

// wave: of the record. depth: D at the gauge, m; where it is not positive, or there is no wave, all is NaN.
GaugeStatistics gauge_statistics(const GaugeRecord& record, const analysis::GaugeWave& wave, double depth,
                                 const scene::Scene& scene);

// Hz; waves of higher frequency are shorter than four cells and so not resolved.
double highest_frequency(double depth, const scene::Scene& scene);

// spectra.csv: x, y, source of the gauge, frequency (Hz) and density (m²/Hz), up to highest_frequency.
void write_spectra(const std::filesystem::path& path, const Waves& waves, const scene::Scene& scene,
                   const Provenance& provenance);

}  // namespace tidewater::postprocess
