// The water surface of one frame for ParaView: the files water_surface_NNNN.vtp.
//
// In 3D triangles between neighbouring places, in 2D lines from place to place, in the plane y = 0; where a
// place is dry or covered there is a hole. Point arrays: `elevation` (m above the still level), `speed` (m/s)
// and `depth` (m above the ground). Data is inline binary, compressed with zlib.
//
// Test: tests/unit/io/water_surface_test.cpp
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "core/provenance.h"
#include "io/surface_file.h"

namespace tidewater::io {

inline constexpr int water_surface_format_version = 1;

// "water_surface_0007.vtp"; more digits from frame 10000 on.
std::string water_surface_name(std::size_t frame);

// speed: m/s, of each place, like surface.elevation; NaN where it is not known. Replaces path as a whole.
// Throws std::invalid_argument if a column does not have place_count() values, OutputError.
void write_water_surface(const std::filesystem::path& path, const Surface& surface,
                         std::span<const float> speed, const Provenance& provenance);

}  // namespace tidewater::io
