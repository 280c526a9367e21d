// Bodies as OpenVDB level sets: signed distance in m on a narrow band of voxels, negative inside.
//
// Each grid carries what the simulate stage needs to fill it with particles, as metadata: `material`
// (core/types.h's name) and `volume` (m³; in 2D m², of the plane y = 0), exact where the geometry stage knows
// it exactly.
#pragma once

#include <openvdb/openvdb.h>

#include <functional>
#include <string>

#include "geometry/box.h"

namespace tidewater::geometry {

// A level set of the given voxel size (m) and three voxels of band on each side, whose surface lies within
// the extent. signed_distance is called in parallel.
openvdb::FloatGrid::Ptr make_level_set(const std::string& name, double voxel_size, const Extent& extent,
                                       const std::function<double(const Point&)>& signed_distance);

void describe_body(openvdb::FloatGrid& level_set, Material material, double volume);

// Whether a grid is what particles are seeded in, or a rigid body.
bool is_body(const openvdb::FloatGrid& level_set);

// From the metadata. Throw InputError naming the grid if it is missing or of a wrong kind.
Material body_material(const openvdb::FloatGrid& level_set);
double body_volume(const openvdb::FloatGrid& level_set);

// Which scene a level set was made for: a fingerprint of what the geometry stage reads of it.
void mark_scene(openvdb::FloatGrid& level_set, const std::string& fingerprint);
std::string marked_scene(const openvdb::FloatGrid& level_set);

}  // namespace tidewater::geometry
