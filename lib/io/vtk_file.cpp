#include "io/vtk_file.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkXMLWriter.h>

#include "core/files.h"

namespace tidewater::io {

void add_field(vtkDataObject* data, const std::string& name, const std::string& text) {
    vtkNew<vtkStringArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(text);
    data->GetFieldData()->AddArray(array);
}

void add_provenance(vtkDataObject* data, const std::string& format, int version,
                    const Provenance& provenance) {
    add_field(data, "format", format);
    add_field(data, "format_version", std::to_string(version));
    for (const auto& [name, text] : provenance_fields(provenance)) add_field(data, name, text);
}

void write_vtk(const std::filesystem::path& path, vtkXMLWriter* writer, vtkDataObject* data) {
    // In memory first: VTK's own writing to a full disk leaves half a file, or crashes.
    writer->WriteToOutputStringOn();
    writer->SetInputDataObject(data);
    writer->SetDataModeToBinary();
    writer->SetCompressorTypeToZLib();
    writer->SetCompressionLevel(1);
    writer->Write();
    write_text(path, writer->GetOutputString());
}

}  // namespace tidewater::io
