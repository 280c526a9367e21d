// Points and the arrays over them, as files of other programs hold them:
//     .vtp, .vtu, .pvtp, .pvtu    VTK's XML files, whole or in pieces
//     .vtk                        VTK's legacy files, polydata or unstructured
//     .hdf, .vtkhdf, .h5, .hdf5   VTKHDF 1 and 2, unstructured or polydata, at one time
// Cells, where there are any, must be vertices: the nodes of a mesh are no particles.
//
// Test: tests/unit/io/particle_files_test.cpp
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <vtkPointSet.h>

namespace tidewater::io {

struct PointCloud {
    vtkSmartPointer<vtkPointSet> data;  // the points and the arrays over them that were wanted
    std::vector<std::string> arrays;    // the names of all that there are, in the file's order
    double time = std::numeric_limits<double>::quiet_NaN();  // s; NaN where the file does not tell
};

// Reads the points and of the arrays the wanted ones, where the file has them. Throws InputError if the file
// is missing, truncated, of a newer format or of another kind.
PointCloud read_point_cloud(const std::filesystem::path& path, const std::set<std::string>& wanted);

// The time alone, s; NaN where the file does not tell, as legacy files never do. Throws likewise, but may not
// notice that a file is truncated.
double read_point_cloud_time(const std::filesystem::path& path);

// Whether the file's name is one of those above.
bool is_point_cloud_name(const std::filesystem::path& path);

}  // namespace tidewater::io
