// How high the water runs up the shore at the far end of the tank.
#pragma once

#include <filesystem>
#include <string>

#include "core/provenance.h"
#include "surface.h"

namespace tidewater::postprocess {

// run_up.csv: per frame time (s), x and y of the waterline (m), height R above the still level (m), at_wall
// (1: the water reaches the end of the tank, and R is its elevation there).
void write_run_up(const std::filesystem::path& path, const Surfaces& surfaces, const Provenance& provenance);

// The line that is printed; empty if there was no water.
std::string describe_run_up(const Surfaces& surfaces, const scene::Scene& scene);

}  // namespace tidewater::postprocess
