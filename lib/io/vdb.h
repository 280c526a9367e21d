// Level sets in one OpenVDB file, as vdb_print and vdb_view read it.
//
// The file's metadata carry the provenance and `tidewater_format`. OpenVDB gives each file a random UUID; it
// is replaced by a fingerprint of the content, so that the same scene gives the same bytes and damage is
// noticed.
#pragma once

#include <openvdb/openvdb.h>

#include <filesystem>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

inline constexpr int level_set_format = 1;

// Grids are written in this order under their names. Throws OutputError.
void write_level_sets(const std::filesystem::path& path, const std::vector<openvdb::FloatGrid::Ptr>& grids,
                      const Provenance& provenance);

// All level sets of the file, in its order. Throws InputError, one line with the file and what to do, if the
// file is missing, no .vdb, not written by tidewater-geometry, of a newer format, truncated or damaged.
std::vector<openvdb::FloatGrid::Ptr> read_level_sets(const std::filesystem::path& path);

}  // namespace tidewater::io
