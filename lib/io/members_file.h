// Which particle is in which iceberg at one time: the files members_NNNN.h5, for h5py and what is made from
// them.
//
// The root has the attributes format, format_version, time (s), given (how many iceberg ids were given so
// far) and the provenance; the arrays are /particle (ids of snapshots, rising) and /iceberg, one entry per
// particle that is in the glacier (0) or in an iceberg; /front, how far the glacier reaches in x, measured
// where its particles were in the first frame, in rows a particle spacing wide (m; NaN: not at all), and
// /front_row, the number of its first row along y. Arrays carry checksums; equal members with equal
// provenance are equal bytes.
//
// Test: tests/unit/io/members_file_test.cpp
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

inline constexpr std::int64_t members_format_version = 1;

struct Members {
    double time = 0.0;                    // s
    std::uint32_t given = 0;              // iceberg ids, from 0 on
    std::vector<std::uint32_t> particle;  // id, rising
    std::vector<std::uint32_t> iceberg;   // of each
    std::vector<double> front;            // x, m
    std::int64_t front_row = 0;
};

// Throws OutputError.
void write_members(const std::filesystem::path& path, const Members& members, const Provenance& provenance);

// Throws InputError if the file is missing, truncated, damaged, foreign or of a newer format version.
Members read_members(const std::filesystem::path& path);

}  // namespace tidewater::io
