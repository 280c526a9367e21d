// The stage's charts, each as the text of an SVG file.
#pragma once

#include <filesystem>
#include <string>

#include "common/stage.h"
#include "gauges.h"
#include "io/table.h"

namespace tidewater::postprocess {

// η over time, a panel per gauge, with arrivals, leading crests and the reflection's return.
std::string gauge_chart(const Waves& waves, const StageContext& context);

// Where leading crest and arrival were when, against √(gD) t from the first gauge's crest.
std::string celerity_chart(const Waves& waves, const StageContext& context);

// Energies over time from the ledger read from `path`: kinetic, gravitational and elastic as changes since
// the start, their sum, and the work done at the boundaries. Throws InputError if a column is missing.
std::string energy_chart(const io::Table& ledger, const std::filesystem::path& path,
                         const StageContext& context);

}  // namespace tidewater::postprocess
