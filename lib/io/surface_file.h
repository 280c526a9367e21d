// The water surface at one time on places a cell apart: the files surface_NNNN.h5, for h5py, xarray and what
// is made from them.
//
// The root has the attributes format, format_version, time (s), still_level (z, m) and the provenance; the
// arrays are /x (m), /y (m; one 0 in 2D), both rising, /bed (height of the ground at each place, m) and /eta
// (η above still_level, m; NaN: dry, or covered by ice or a block), the latter two with a row of x per y, one
// behind the other. Every array carries checksums; equal surfaces with equal provenance are equal bytes.
//
// Test: tests/unit/io/surface_file_test.cpp
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

inline constexpr std::int64_t surface_format_version = 1;

struct Surface {
    double time = 0.0;             // s
    double still_level = 0.0;      // z, m
    std::vector<double> x, y;      // m
    std::vector<float> bed;        // m, at (x[i], y[j]) as entry i + x.size() j
    std::vector<float> elevation;  // η, m, likewise

    std::size_t place_count() const { return x.size() * y.size(); }
};

// "surface_0007.h5"; more digits from frame 10000 on.
std::string surface_name(std::size_t frame);

// bed and elevation must have place_count() values. Throws OutputError.
void write_surface(const std::filesystem::path& path, const Surface& surface, const Provenance& provenance);

// Throws InputError if the file is missing, truncated, damaged, foreign or of a newer format version.
Surface read_surface(const std::filesystem::path& path);

}  // namespace tidewater::io
