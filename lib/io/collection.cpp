#include "io/collection.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <numeric>

#include "core/files.h"
#include "io/text.h"
#include "io/vtk_file.h"

namespace tidewater::io {
namespace {

// A VTK array over memory that outlives it, without a copy. VTK does not write to it.
template <class T>
vtkNew<vtkAOSDataArrayTemplate<T>> borrow(const char* name, int components, const std::vector<T>& values) {
    vtkNew<vtkAOSDataArrayTemplate<T>> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    constexpr int keep = 1;
    array->SetArray(const_cast<T*>(values.data()), static_cast<vtkIdType>(values.size()), keep);
    return array;
}

std::vector<float> magnitudes(const std::vector<float>& vectors) {
    std::vector<float> result(vectors.size() / 3);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = std::hypot(vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]);
    }
    return result;
}

// One poly-vertex cell over all points; no cell where there are none.
vtkNew<vtkCellArray> one_cell(std::size_t point_count) {
    vtkNew<vtkCellArray> cells;
    if (point_count == 0) return cells;
    std::vector<vtkIdType> indices(point_count);
    std::iota(indices.begin(), indices.end(), vtkIdType{0});
    cells->InsertNextCell(static_cast<vtkIdType>(point_count), indices.data());
    return cells;
}

// Within an XML comment there must be no "--": a blank goes between.
std::string xml_comment(const Provenance& provenance) {
    std::string text;
    for (const auto& [name, value] : provenance_fields(provenance)) text += name + ": " + value + "\n";
    for (auto at = text.find("--"); at != std::string::npos; at = text.find("--", at))
        text.insert(at + 1, " ");
    return "<!--\n" + text + "-->\n";
}

}  // namespace

std::string particles_name(std::size_t frame) {
    return numbered_name("particles", frame, "vtp");
}

void write_particles(const std::filesystem::path& path, const Snapshot& snapshot,
                     const Provenance& provenance) {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetData(borrow("points", 3, snapshot.points));
    data->SetPoints(points);
    data->SetVerts(one_cell(snapshot.particle_count()));
    for_each_column([&](const auto& column) {
        if (left_out(snapshot, column)) return;
        data->GetPointData()->AddArray(borrow(column.name, column.components, snapshot.*column.values));
    });
    const std::vector<float> speed = magnitudes(snapshot.velocity);
    data->GetPointData()->AddArray(borrow("velocity_magnitude", 1, speed));
    add_provenance(data, "tidewater-particles", particles_format_version, provenance);
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_vtk(path, writer, data);
}

void write_collection(const std::filesystem::path& path, const std::vector<CollectionEntry>& entries,
                      const Provenance& provenance) {
    std::string xml = "<?xml version=\"1.0\"?>\n" + xml_comment(provenance) +
                      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                      "  <Collection>\n";
    for (const CollectionEntry& entry : entries) {
        xml += "    <DataSet timestep=\"" + format_number(entry.time) + "\" part=\"0\" file=\"" +
               escape_xml(entry.name) + "\"/>\n";
    }
    write_text(path, xml + "  </Collection>\n</VTKFile>\n");
}

}  // namespace tidewater::io
