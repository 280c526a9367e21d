// What writers of VTK's XML files share: field data that say where a file comes from, and the file as a
// whole. ParaView 5.11 of Debian cannot open appended data, so data are inline binary, compressed.
#pragma once

#include <filesystem>
#include <string>

#include "core/provenance.h"

class vtkDataObject;

namespace tidewater::io {

// A text among the data's field data.
void add_field(vtkDataObject* data, const std::string& name, const std::string& text);

// The fields format, format_version and those of the provenance.
void add_provenance(vtkDataObject* data, const std::string& format, int version,
                    const Provenance& provenance);

enum class VtkPacking {
    zlib,  // the smallest files
    lz4,   // five times as fast, for particles: files 20 % larger
};

// Replaces path as a whole by the data as a `Writer` of VTK (vtkXMLPolyDataWriter, vtkXMLImageDataWriter)
// writes them. Throws OutputError.
template <class Writer>
void write_vtk(const std::filesystem::path& path, vtkDataObject* data, VtkPacking packing = VtkPacking::zlib);

}  // namespace tidewater::io
