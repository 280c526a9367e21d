#include "io/vtkhdf_points.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

#include "io/hdf5_file.h"

namespace tidewater::io {
namespace {

constexpr std::int64_t newest_version = 2;
constexpr const char* arrays_group = "/VTKHDF/PointData";
constexpr const char* steps_group = "/VTKHDF/Steps";

Hdf5Reader open(const std::filesystem::path& path) {
    Hdf5Reader file(path, "write it again, or copy it again");
    if (!file.has_array("/VTKHDF") || !file.has_attribute("/VTKHDF", "Version"))
        file.fail("it is an HDF5 file but no VTKHDF");
    const auto version = file.integers("/VTKHDF", "Version");
    if (version.empty() || version[0] > newest_version) {
        file.fail("its VTKHDF version " + (version.empty() ? "" : std::to_string(version[0])) +
                  " is newer than this program's " + std::to_string(newest_version));
    }
    return file;
}

// The cells must be vertices or poly-vertices.
void require_cloud(const Hdf5Reader& file) {
    const std::string type = file.text("/VTKHDF", "Type");
    if (type != "UnstructuredGrid" && type != "PolyData")
        file.fail("it holds " + type + "; particles are needed");
    if (type == "UnstructuredGrid" && file.has_array("/VTKHDF/Types")) {
        const auto cells = file.array<std::uint8_t>("/VTKHDF/Types");
        if (std::ranges::all_of(cells, [](std::uint8_t cell) { return cell <= 2; })) return;
        file.fail("it holds a mesh, whose nodes are no particles");
    }
    for (const char* group : {"/VTKHDF/Lines", "/VTKHDF/Polygons", "/VTKHDF/Strips"}) {
        const std::string connectivity = std::string(group) + "/Connectivity";
        if (file.has_array(group) && file.has_array(connectivity) && file.shape(connectivity)[0] > 0)
            file.fail("it holds a mesh, whose nodes are no particles");
    }
}

void require_one_time(const Hdf5Reader& file) {
    if (!file.has_array(steps_group)) return;
    const std::int64_t steps = file.integer(steps_group, "NSteps");
    if (steps != 1) file.fail("it holds " + std::to_string(steps) + " times; write one file for each");
}

double time_of(const Hdf5Reader& file) {
    if (file.has_array(steps_group)) {
        const auto times = file.array<double>(std::string(steps_group) + "/Values");
        if (!times.empty()) return times.front();
    }
    if (file.has_attribute("/", "time")) return file.number("/", "time");
    return std::numeric_limits<double>::quiet_NaN();
}

// As doubles, which hold every integer that an id may be.
vtkNew<vtkDoubleArray> read_array(const Hdf5Reader& file, const std::string& path, const std::string& name) {
    const auto shape = file.shape(path);
    if (shape.empty() || shape.size() > 2) file.fail("array " + path + " is neither a list nor a table");
    const int columns = shape.size() == 2 ? static_cast<int>(shape[1]) : 0;
    const std::vector<double> values = file.array<double>(path, columns);
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(std::max(columns, 1));
    array->SetNumberOfTuples(static_cast<vtkIdType>(shape[0]));
    std::ranges::copy(values, array->GetPointer(0));
    return array;
}

}  // namespace

PointCloud read_vtkhdf_points(const std::filesystem::path& path, const std::set<std::string>& wanted) {
    const Hdf5Reader file = open(path);
    require_cloud(file);
    require_one_time(file);
    PointCloud cloud;
    cloud.time = time_of(file);
    cloud.data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    const auto places = read_array(file, "/VTKHDF/Points", "points");
    if (places->GetNumberOfComponents() != 3) file.fail("array /VTKHDF/Points does not have 3 components");
    points->SetData(places);
    cloud.data->SetPoints(points);
    for (const std::string& name : file.array_names(arrays_group)) {
        cloud.arrays.push_back(name);
        if (wanted.contains(name))
            cloud.data->GetPointData()->AddArray(
                read_array(file, std::string(arrays_group) + "/" + name, name));
    }
    return cloud;
}

double read_vtkhdf_time(const std::filesystem::path& path) { return time_of(open(path)); }

}  // namespace tidewater::io
