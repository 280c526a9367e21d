// The stage's charts, each as the text of an SVG file, which write_chart writes as a PNG file too.
#pragma once

#include <filesystem>
#include <string>

#include "bodies.h"
#include "common/stage.h"
#include "energy_split.h"
#include "gauges.h"
#include "io/table.h"
#include "tsunami.h"

namespace tidewater::postprocess {

// <name>.svg and <name>.png in the stage's folder.
void write_chart(const StageContext& context, const std::string& name, const std::string& svg);

// η over time, a panel per gauge, with arrivals, leading crests and the reflection's return.
std::string gauge_chart(const Waves& waves, const StageContext& context);

// Where leading crest and arrival were when, against √(gD) t from the first gauge's crest.
std::string celerity_chart(const Waves& waves, const StageContext& context);

// Energies over time from the ledger read from `path`: kinetic, gravitational and elastic as changes since
// the start, their sum, and the work done at the boundaries. Throws InputError if a column is missing.
std::string energy_chart(const io::Table& ledger, const std::filesystem::path& path,
                         const StageContext& context);

// Height, angle and fastest speed of the blocks over time, a line per block.
std::string body_chart(const std::vector<Body>& bodies, const StageContext& context);

// Where the energy went over time.
std::string energy_split_chart(const EnergySplit& split, const StageContext& context);

// The paper's Fig. 2b: the leading crest's amplitude over its greatest, and how far it ran from where it was
// greatest, against √(gD) t, both over the time since then; a line per way.
std::string first_wave_chart(const Tsunami& tsunami, const StageContext& context);

}  // namespace tidewater::postprocess
