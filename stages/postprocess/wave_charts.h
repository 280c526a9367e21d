// Charts of waves over the whole run, each as the text of an SVG file.
#pragma once

#include <string>

#include "common/stage.h"
#include "gauges.h"
#include "io/wave_records_nc.h"
#include "surface.h"
#include "wave_decay.h"

namespace tidewater::postprocess {

// E(f), a panel per gauge, with the peak.
std::string spectra_chart(const Waves& waves, const StageContext& context);

// Crests over r/D, both logarithmic, with the fit and the lines of r^-1/3, r^-1/2 and r^-5/6.
std::string decay_chart(const WaveDecay& decay, const StageContext& context);

// η over x and time along the middle of the tank, with the path of a long wave, dx/dt = √(g D(x)) over the
// still depth there, through the leading crest at the first gauge on the path.
std::string space_time_chart(const Surfaces& surfaces, const Waves& waves, const WavePath& path,
                             const StageContext& context);

// Run-up, or elevation at the far wall, over time.
std::string run_up_chart(const Surfaces& surfaces, const StageContext& context);

// The same η for space_time.nc.
io::SpaceTime space_time_record(const Surfaces& surfaces, const StageContext& context);

}  // namespace tidewater::postprocess
