// What tidewater-point writes and prints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "options.h"

namespace tidewater::point {

// One line per step, the columns of mpm::PointRow. Throws OutputError.
void write_csv(const std::filesystem::path& path, const std::vector<mpm::PointRow>& rows,
               const Provenance& provenance);

// SVG: the path on the yield surface as in Fig. 6 of Wolper et al. (2021), and p, q and p0 over the strain.
std::string draw_path(const Options& options, const std::vector<mpm::PointRow>& rows,
                      const Provenance& provenance);

// What a calibrator wants first: closed forms of the model, and milestones of the path.
std::string summary(const Options& options, const std::vector<mpm::PointRow>& rows);

}  // namespace tidewater::point
