// What earlier runs left: the scene that was simulated, and this stage's own old results.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace tidewater::postprocess {

// Throws InputError if the run in `simulated` was made of another scene, as far as simulate reads it, or does
// not say of which: its gauges and snapshots would be told as results of this one.
void require_same_scene(const std::filesystem::path& simulated, const scene::Scene& scene);

// Removes what this stage may have written to its folder of the whole run, whole or as .part, which could
// name other frames or gauges; report.html first. Single frames' files, of which stamps.h knows what they
// were made from, and other files stay. Throws OutputError.
void remove_earlier_results(const std::filesystem::path& folder);

}  // namespace tidewater::postprocess
