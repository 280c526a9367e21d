#include "io/collection.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <numeric>

#include "core/files.h"
#include "core/random.h"
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

// One poly-vertex cell over all points; no cell where there are none. Indices of 32 bits halve it.
vtkNew<vtkCellArray> one_cell(std::size_t point_count) {
    vtkNew<vtkCellArray> cells;
    if (point_count == 0) return cells;
    vtkNew<vtkTypeInt32Array> offsets, indices;
    offsets->InsertNextValue(0);
    offsets->InsertNextValue(static_cast<vtkTypeInt32>(point_count));
    indices->SetNumberOfValues(static_cast<vtkIdType>(point_count));
    std::iota(indices->GetPointer(0), indices->GetPointer(0) + point_count, 0);
    cells->SetData(offsets, indices);
    return cells;
}

template <class T>
void keep(const std::vector<std::size_t>& chosen, std::size_t components, const std::vector<T>& from,
          std::vector<T>& to) {
    to.reserve(chosen.size() * components);
    for (const std::size_t p : chosen) {
        for (std::size_t c = 0; c < components; ++c) to.push_back(from[p * components + c]);
    }
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

std::string particles_name(std::size_t frame) { return numbered_name("particles", frame, "vtp"); }

Snapshot thin_out(const Snapshot& snapshot, int every) {
    Snapshot kept;
    kept.dimension = snapshot.dimension;
    kept.time = snapshot.time;
    std::vector<std::size_t> chosen;
    for (std::size_t p = 0; every > 0 && p < snapshot.particle_count(); ++p) {
        if (mix64(snapshot.id[p]) % static_cast<std::uint64_t>(every) == 0) chosen.push_back(p);
    }
    keep(chosen, 3, snapshot.points, kept.points);
    for_each_column([&](const auto& column) {
        if (left_out(snapshot, column)) return;
        keep(chosen, static_cast<std::size_t>(column.components), snapshot.*column.values,
             kept.*column.values);
    });
    return kept;
}

void write_particles(const std::filesystem::path& path, const Snapshot& snapshot,
                     const DerivedColumns& derived, const Provenance& provenance) {
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
    const auto add = [&](const char* name, const auto& values) {
        if (!values.empty()) data->GetPointData()->AddArray(borrow(name, 1, values));
    };
    add("alpha", derived.alpha);
    add("p0", derived.p0);
    add("iceberg", derived.iceberg);
    add_provenance(data, "tidewater-particles", particles_format_version, provenance);
    write_vtk<vtkXMLPolyDataWriter>(path, data, VtkPacking::lz4);
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
