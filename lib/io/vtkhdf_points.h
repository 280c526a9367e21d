// The points of a VTKHDF file of another program and the arrays over them. VTK 9.1's own reader knows neither
// polydata nor files that tell a time, which are later than it. Source: the VTK documentation, "VTKHDF file
// format".
#pragma once

#include "io/point_cloud.h"

namespace tidewater::io {

// As read_point_cloud and read_point_cloud_time.
PointCloud read_vtkhdf_points(const std::filesystem::path& path, const std::set<std::string>& wanted);
double read_vtkhdf_time(const std::filesystem::path& path);

}  // namespace tidewater::io
