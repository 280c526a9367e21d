// Height fields as OpenVDB grids, so that they lie in the same file as the level sets: the voxel (i, j, 0)
// holds the height in m of the place (i, j) times the voxel size, or of (i, 0) in 2D.
#pragma once

#include <string>

#include "geometry/height_field.h"
#include "geometry/level_set.h"

namespace tidewater::geometry {

inline const std::string bed_heights = "bed_height", ice_surface = "ice_surface";

// Of a field that begins at x = y = 0. Heights are rounded to float: 3e-5 m at 500 m.
openvdb::FloatGrid::Ptr height_grid(const std::string& name, const HeightField& field);

// Throws InputError naming the grid if it is none.
HeightField height_field(const openvdb::FloatGrid& grid);

}  // namespace tidewater::geometry
