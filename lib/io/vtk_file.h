// What writers of VTK's XML files share: field data that say where a file comes from, and the file as a
// whole. ParaView 5.11 of Debian cannot open appended data, so data are inline binary, compressed with zlib.
#pragma once

#include <filesystem>
#include <string>

#include "core/provenance.h"

class vtkDataObject;
class vtkXMLWriter;

namespace tidewater::io {

// A text among the data's field data.
void add_field(vtkDataObject* data, const std::string& name, const std::string& text);

// The fields format, format_version and those of the provenance.
void add_provenance(vtkDataObject* data, const std::string& format, int version,
                    const Provenance& provenance);

// Replaces path as a whole by the data as the writer writes them. Throws OutputError.
void write_vtk(const std::filesystem::path& path, vtkXMLWriter* writer, vtkDataObject* data);

}  // namespace tidewater::io
