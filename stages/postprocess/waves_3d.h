// waves_3d.csv: a wave in 3D at r/D from 2 to 35, by analysis/radial_wave.h.
#pragma once

#include <filesystem>
#include <functional>

#include "analysis/radial_wave.h"
#include "core/provenance.h"

namespace tidewater::postprocess {

inline constexpr const char* outside_range = "outside the validated range";

// greatest: amplitude in 2D, m; here(r): that at r m from the source, m (NaN: not known).
void write_waves_3d(const std::filesystem::path& path, const analysis::Slide& slide,
                    const analysis::ImpulseProduct& impulse, double greatest,
                    const std::function<double(double)>& here, const Provenance& provenance);

}  // namespace tidewater::postprocess
