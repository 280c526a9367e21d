#include "io/vtk_file.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOutputStream.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <ostream>

#include "core/error.h"
#include "core/files.h"

namespace tidewater::io {
namespace {

// A file that takes what it gets even where the disk is full, and remembers the failure: VTK's writers crash
// on a stream that fails in between.
class PatientFile : public std::filebuf {
public:
    int error() const { return error_; }
    void finish() {
        if (close() == nullptr) note();
    }

protected:
    std::streamsize xsputn(const char* text, std::streamsize count) override {
        if (error_ == 0 && std::filebuf::xsputn(text, count) != count) note();
        return count;
    }
    int_type overflow(int_type letter) override {
        if (error_ == 0 && traits_type::eq_int_type(std::filebuf::overflow(letter), traits_type::eof()))
            note();
        return traits_type::not_eof(letter);
    }
    int sync() override {
        if (error_ == 0 && std::filebuf::sync() != 0) note();
        return 0;
    }
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode mode) override {
        return place(error_ == 0 ? std::filebuf::seekoff(offset, from, mode) : pos_type(off_type(-1)));
    }
    pos_type seekpos(pos_type at, std::ios_base::openmode mode) override {
        return place(error_ == 0 ? std::filebuf::seekpos(at, mode) : pos_type(off_type(-1)));
    }

private:
    void note() {
        if (error_ == 0) error_ = errno != 0 ? errno : EIO;
    }
    pos_type place(pos_type at) {
        if (at != pos_type(off_type(-1))) return at;
        note();
        return pos_type(off_type(0));
    }

    int error_ = 0;
};

// VTK's writer onto a stream of ours. VTK's own ways are a file that it opens, see above, and the whole text
// in memory, twice.
template <class Writer>
class StreamWriter : public Writer {
public:
    static StreamWriter* New() {
        auto* writer = new StreamWriter;
        writer->InitializeObjectBase();
        return writer;
    }
    void write_to(std::ostream& stream) {
        target_ = &stream;
        this->WriteToOutputStringOn();  // says that it needs no file's name
        this->Write();
    }

protected:
    int StartFile() override {  // the first that is called once a stream is open
        this->Stream = target_;
        this->Stream->imbue(std::locale::classic());
        this->GetDataStream()->SetStream(target_);  // that of numbers, which encodes them
        return Writer::StartFile();
    }

private:
    std::ostream* target_ = nullptr;
};

}  // namespace

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

template <class Writer>
void write_vtk(const std::filesystem::path& path, vtkDataObject* data, VtkPacking packing) {
    PartFile part(path);
    PatientFile file;
    file.open(part.part_path(), std::ios::out | std::ios::binary | std::ios::trunc);
    std::ostream stream(&file);
    vtkNew<StreamWriter<Writer>> writer;
    writer->SetInputDataObject(data);
    writer->SetDataModeToBinary();
    if (packing == VtkPacking::lz4) {
        writer->SetCompressorTypeToLZ4();
        writer->SetBlockSize(1 << 20);  // bytes; smaller blocks take longer
    } else {
        writer->SetCompressorTypeToZLib();
    }
    writer->SetCompressionLevel(1);
    writer->write_to(stream);
    file.finish();
    if (file.error() != 0) {
        throw OutputError(path.string() + ": writing failed: " + std::strerror(file.error()) +
                          "; is the disk full?");
    }
    part.commit();
}

template void write_vtk<vtkXMLPolyDataWriter>(const std::filesystem::path&, vtkDataObject*, VtkPacking);
template void write_vtk<vtkXMLImageDataWriter>(const std::filesystem::path&, vtkDataObject*, VtkPacking);

}  // namespace tidewater::io
