#include "io/point_cloud.h"

#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkFieldData.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "core/error.h"
#include "io/vtk_messages.h"
#include "io/vtkhdf_points.h"

namespace tidewater::io {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& problem) {
    throw InputError(path.string() + ": " + problem);
}

void require_file(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) fail(path, "the file does not exist; check the path");
}

bool is_vtkhdf(const std::string& extension) {
    return extension == ".hdf" || extension == ".vtkhdf" || extension == ".h5" || extension == ".hdf5";
}

// Nothing where the file is not of VTK's XML kind.
vtkSmartPointer<vtkXMLReader> xml_reader(const std::filesystem::path& path) {
    const std::string extension = path.extension();
    vtkSmartPointer<vtkXMLReader> reader;
    if (extension == ".vtp") reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    if (extension == ".vtu") reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
    if (extension == ".pvtp") reader = vtkSmartPointer<vtkXMLPPolyDataReader>::New();
    if (extension == ".pvtu") reader = vtkSmartPointer<vtkXMLPUnstructuredGridReader>::New();
    if (reader) reader->SetFileName(path.c_str());
    return reader;
}

// VTK's own words for a file that it did not understand, on one line and without its source's place.
std::string in_one_line(const std::string& message) {
    std::string line = message.substr(std::min(message.find("): "), message.size()));
    line.erase(0, line.empty() ? 0 : 3);
    std::ranges::replace(line, '\n', ' ');
    while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
    return line.empty() ? "" : " (" + line + ")";
}

void require_read(const std::filesystem::path& path, const QuietVtk& quiet, bool has_data) {
    if (has_data && !quiet.failed()) return;
    fail(path, "it is truncated, damaged, of a newer format or not what its name says" +
                   in_one_line(quiet.first_error()) + "; write it again, or copy it again");
}

std::string read_start(const std::filesystem::path& path) {
    constexpr std::size_t longest = 65536;
    std::string text(longest, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

void require_known_version(const std::filesystem::path& path, int version, int newest) {
    if (version <= newest) return;
    fail(path, "its format version " + std::to_string(version) + " is newer than the " +
                   std::to_string(newest) + " that is read; write it in an older one");
}

// VTK's own reader takes a newer file without a word, as far as it understands it.
void require_xml_version(const std::filesystem::path& path) {
    constexpr int newest = 2;
    const std::string text = read_start(path);
    const auto root = text.find("<VTKFile");
    const auto attribute = text.find(" version=", root == std::string::npos ? text.size() : root);
    int version = 0;
    if (attribute == std::string::npos ||
        std::sscanf(text.c_str() + attribute, " version=%*[\"']%d", &version) != 1)
        return;
    require_known_version(path, version, newest);
}

bool is_cloud(vtkPointSet& data) {
    if (auto* surface = vtkPolyData::SafeDownCast(&data)) {
        return surface->GetNumberOfLines() + surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0;
    }
    auto* grid = vtkUnstructuredGrid::SafeDownCast(&data);
    if (grid == nullptr) return false;
    vtkNew<vtkCellTypes> types;
    grid->GetCellTypes(types);
    for (vtkIdType n = 0; n < types->GetNumberOfTypes(); ++n) {
        const int type = types->GetCellType(n);
        if (type != VTK_VERTEX && type != VTK_POLY_VERTEX && type != VTK_EMPTY_CELL) return false;
    }
    return true;
}

// The points and what is over them, of data that must be particles.
PointCloud take_points(const std::filesystem::path& path, vtkDataObject* data) {
    PointCloud cloud;
    cloud.data = vtkPointSet::SafeDownCast(data);
    if (!cloud.data)
        fail(path, std::string("it holds ") + data->GetClassName() + ", a grid; particles are needed");
    if (!is_cloud(*cloud.data))
        fail(path, "it holds a mesh, whose nodes are no particles; write a vertex for each particle");
    if (vtkDataArray* time = data->GetFieldData()->GetArray("TimeValue");
        time != nullptr && time->GetNumberOfValues() > 0)
        cloud.time = time->GetComponent(0, 0);
    return cloud;
}

PointCloud read_xml(const std::filesystem::path& path, vtkXMLReader& reader,
                    const std::set<std::string>& wanted) {
    const QuietVtk quiet;
    require_xml_version(path);
    reader.UpdateInformation();
    require_read(path, quiet, true);
    vtkDataArraySelection* selection = reader.GetPointDataArraySelection();
    std::vector<std::string> names;
    for (int n = 0; n < selection->GetNumberOfArrays(); ++n) names.emplace_back(selection->GetArrayName(n));
    selection->DisableAllArrays();
    for (const std::string& name : names) {
        if (wanted.contains(name)) selection->EnableArray(name.c_str());
    }
    reader.Update();
    vtkDataObject* data = reader.GetOutputDataObject(0);
    require_read(path, quiet, data != nullptr);
    PointCloud cloud = take_points(path, data);
    cloud.arrays = names;
    return cloud;
}

// The first lines of a legacy file tell its version and how many points there are, of which type. VTK's own
// reader crashes where a file ends before it has told.
void require_legacy_header(const std::filesystem::path& path) {
    constexpr int newest = 5;
    const std::string text = read_start(path);
    int version = 0;
    const bool has_version = std::sscanf(text.c_str(), "# vtk DataFile Version %d", &version) == 1;
    require_known_version(path, version, newest);
    const auto kind = std::min(text.find("DATASET POLYDATA"), text.find("DATASET UNSTRUCTURED_GRID"));
    const bool is_grid = kind == std::string::npos && text.find("DATASET ") != std::string::npos;
    const auto points = text.find("POINTS ");
    const bool has_points = points != std::string::npos && text.find('\n', points) != std::string::npos;
    if (!has_version || !(is_grid || has_points))
        fail(path, "it is truncated or no legacy VTK file; write it again, or copy it again");
}

PointCloud read_legacy(const std::filesystem::path& path) {
    const QuietVtk quiet;
    require_legacy_header(path);
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(path.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllFieldsOn();
    reader->Update();
    vtkDataObject* data = reader->GetOutput();
    require_read(path, quiet, data != nullptr);
    PointCloud cloud = take_points(path, data);
    vtkPointData* arrays = cloud.data->GetPointData();
    for (int n = 0; n < arrays->GetNumberOfArrays(); ++n) {
        if (arrays->GetArrayName(n) != nullptr) cloud.arrays.emplace_back(arrays->GetArrayName(n));
    }
    return cloud;
}

double read_xml_time(const std::filesystem::path& path, vtkXMLReader& reader) {
    const QuietVtk quiet;
    reader.UpdateInformation();
    require_read(path, quiet, true);
    vtkInformation* information = reader.GetOutputInformation(0);
    auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
    return information->Has(key) && information->Length(key) > 0 ? information->Get(key, 0) : unknown;
}

}  // namespace

PointCloud read_point_cloud(const std::filesystem::path& path, const std::set<std::string>& wanted) {
    require_file(path);
    if (is_vtkhdf(path.extension())) return read_vtkhdf_points(path, wanted);
    if (const auto reader = xml_reader(path)) return read_xml(path, *reader, wanted);
    if (path.extension() == ".vtk") return read_legacy(path);
    fail(path,
         "its name ends like none of .vtp, .vtu, .pvtp, .pvtu, .vtk, .hdf, .vtkhdf, .h5; convert it to one "
         "of these");
}

double read_point_cloud_time(const std::filesystem::path& path) {
    require_file(path);
    if (is_vtkhdf(path.extension())) return read_vtkhdf_time(path);
    const auto reader = xml_reader(path);
    return reader ? read_xml_time(path, *reader) : unknown;
}

bool is_point_cloud_name(const std::filesystem::path& path) {
    return is_vtkhdf(path.extension()) || xml_reader(path) || path.extension() == ".vtk";
}

}  // namespace tidewater::io
