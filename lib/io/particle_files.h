// Snapshots from particle files of other programs (point_cloud.h says of which kinds), and our own.
//
// What such a file need not have is put in its place: pressure NaN, id the row, volume and material what the
// caller knows; velocity it must have. Columns are made of arrays of integers or floating-point numbers as
// the map says (column_map.h). A vector of two components, in 2D, is along x and up.
//
// The files' axes are (x, y, z) with z up as ours, or with y up: then their (x, y, z) is our (x, -z, y). In
// 2D the points must lie in one plane across our y.
//
// Test: tests/unit/io/particle_files_test.cpp
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/column_map.h"
#include "io/snapshot.h"

namespace tidewater::io {

struct ParticleImport {
    int dimension = 2;  // 2 or 3
    ColumnMap map;
    MaterialNumbers materials;
    bool y_up = false;
    std::array<double, 3> origin{};    // m, in the files' axes: the point that is our origin
    std::optional<Material> material;  // of all particles, where the files do not tell
    double volume = 0.0;               // m³ (2D: m²) of each, where the files do not tell; 0: they must
};

// The time is NaN where the file does not tell. Throws InputError with the file, the column and the arrays
// that there are, if the file is none of those kinds, is damaged, or lacks a column or has no usable one.
// `notes`, if given, gets a line for each column that the file does not have and what is in its place.
Snapshot read_particle_file(const std::filesystem::path& path, const ParticleImport& import,
                            std::vector<std::string>* notes = nullptr);

// The time alone, s; NaN where the file does not tell.
double read_particle_time(const std::filesystem::path& path);

}  // namespace tidewater::io
