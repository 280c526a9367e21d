// Level sets as files that ParaView opens (it has no reader of .vdb): their surfaces as polygons, and an
// image.
//
// Both carry `format`, `format_version` and the provenance as field data, inline binary compressed with zlib.
#pragma once

#include <openvdb/openvdb.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

inline constexpr int surfaces_format_version = 1;
inline constexpr int image_format_version = 1;

// A level set and the number that stands for it in the arrays of both files.
struct NumberedLevelSet {
    openvdb::FloatGrid::ConstPtr grid;
    std::uint8_t number = 1;
};

// The surfaces of all level sets as one .vtp: points in m, quadrilaterals (OpenVDB's dual contouring, so
// edges and corners are rounded off by up to a voxel) whose corners go around counterclockwise seen from
// outside, and the point array `body` with the numbers. The field `bodies` says which is which: "1 bed, 2
// water". Replaces path as a whole. Throws OutputError. Test: tests/unit/io/level_set_files_test.cpp
void write_surfaces(const std::filesystem::path& path, const std::vector<NumberedLevelSet>& level_sets,
                    const Provenance& provenance);

// The part of space that an image shows: its points are those of the level sets' voxels from `low` to `high`,
// m; in 2D those of the plane y = 0 alone.
struct ImageExtent {
    int dimension = 3;
    std::array<double, 3> low{}, high{};
};

// Voxels as a .vti: the point array `material`, the number of the last level set that holds the point, else
// 0, and, if `distances`, a float array per level set under its name: the signed distance in m, negative
// inside, ± the band's width beyond it. 1 byte a voxel in memory, and 4 more for each level set with
// distances, which compress well. All level sets must have one voxel size. Replaces path as a whole. Throws
// OutputError.
void write_image(const std::filesystem::path& path, const std::vector<NumberedLevelSet>& level_sets,
                 const ImageExtent& extent, bool distances, const Provenance& provenance);

}  // namespace tidewater::io
