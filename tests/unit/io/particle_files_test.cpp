#include "io/particle_files.h"

#include <doctest/doctest.h>

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkStructuredPointsWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <cmath>
#include <functional>

#include "core/files.h"
#include "io/collection.h"
#include "io/hdf5_file.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

constexpr int count = 5;

// Five particles in 3D: point and velocity differ along every axis, and each kind of number occurs.
void fill(vtkPointSet* data) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> velocity;
    vtkNew<vtkDoubleArray> damage, speed_up, time, state;
    vtkNew<vtkIntArray> number, kind;
    velocity->SetNumberOfComponents(3);
    state->SetNumberOfComponents(4);
    const std::array<std::pair<vtkDataArray*, const char*>, 6> named{
        {{velocity, "vel"}, {damage, "D"}, {number, "Idp"}, {kind, "Mk"}, {speed_up, "w"}, {state, "state"}}};
    for (int i = 0; i < count; ++i) {
        points->InsertNextPoint(i, 0.5 * i, 10.0 + i);
        velocity->InsertNextTuple3(i, 2.0 * i, -3.0 * i);
        damage->InsertNextValue(0.2 * i);
        speed_up->InsertNextValue(7.0 * i);
        state->InsertNextTuple4(0.0, 1.0, 0.1 * i, 2.0);
        number->InsertNextValue(100 - i);
        kind->InsertNextValue(i == 0 ? 5 : 3);
    }
    for (const auto& [array, name] : named) {
        array->SetName(name);
        data->GetPointData()->AddArray(array);
    }
    data->SetPoints(points);
    time->SetName("TimeValue");
    time->InsertNextValue(1.5);
    data->GetFieldData()->AddArray(time);
}

vtkNew<vtkPolyData> poly_data() {
    vtkNew<vtkPolyData> data;
    fill(data);
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < count; ++i) cells->InsertNextCell(1, &i);
    data->SetVerts(cells);
    return data;
}

vtkNew<vtkUnstructuredGrid> grid(int cell_type = VTK_VERTEX, vtkIdType cell_points = 1) {
    vtkNew<vtkUnstructuredGrid> data;
    fill(data);
    data->Allocate(count);
    const std::array<vtkIdType, 4> ids{0, 1, 2, 3};
    data->InsertNextCell(cell_type, cell_points, ids.data());
    return data;
}

template <class Writer>
void write(
    const std::filesystem::path& path, vtkDataObject* data,
    const std::function<void(Writer*)>& set = [](Writer*) {}) {
    vtkNew<Writer> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputDataObject(data);
    set(writer);
    writer->Write();
}

void write_vtkhdf(const std::filesystem::path& path, std::array<std::int64_t, 2> version, std::int64_t steps,
                  std::uint8_t cell = 1) {
    Hdf5Writer file(path);
    file.group("/VTKHDF");
    file.attribute("/VTKHDF", "Version", version);
    file.attribute("/VTKHDF", "Type", "UnstructuredGrid");
    std::vector<double> points, velocity, damage, up, state;
    std::vector<std::int64_t> number, kind;
    for (int i = 0; i < count; ++i) {
        for (const double value : {1.0 * i, 0.5 * i, 10.0 + i}) points.push_back(value);
        for (const double value : {1.0 * i, 2.0 * i, -3.0 * i}) velocity.push_back(value);
        for (const double value : {0.0, 1.0, 0.1 * i, 2.0}) state.push_back(value);
        damage.push_back(0.2 * i);
        up.push_back(7.0 * i);
        number.push_back(100 - i);
        kind.push_back(i == 0 ? 5 : 3);
    }
    file.array<double>("/VTKHDF/Points", points, 3);
    file.array<std::uint8_t>("/VTKHDF/Types", std::vector<std::uint8_t>(count, cell));
    file.group("/VTKHDF/PointData");
    file.array<double>("/VTKHDF/PointData/vel", velocity, 3);
    file.array<double>("/VTKHDF/PointData/state", state, 4);
    file.array<double>("/VTKHDF/PointData/D", damage);
    file.array<double>("/VTKHDF/PointData/w", up, 1);
    file.array<std::int64_t>("/VTKHDF/PointData/Idp", number);
    file.array<std::int64_t>("/VTKHDF/PointData/Mk", kind);
    if (steps > 0) {
        file.group("/VTKHDF/Steps");
        file.attribute("/VTKHDF/Steps", "NSteps", std::array{steps});
        file.array<double>("/VTKHDF/Steps/Values", std::vector<double>(static_cast<std::size_t>(steps), 1.5));
    }
    file.close();
}

ParticleImport import_3d(const char* map = "velocity=vel,damage=D,id=Idp,material=Mk") {
    ParticleImport import;
    import.dimension = 3;
    import.map = parse_column_map(map);
    import.materials = parse_material_numbers("ice=5,water=3");
    import.volume = 0.25;
    return import;
}

void check_particles(const Snapshot& snapshot) {
    REQUIRE(snapshot.particle_count() == count);
    CHECK(snapshot.dimension == 3);
    for (std::size_t i = 0; i < count; ++i) {
        CAPTURE(i);
        const auto value = static_cast<float>(i);
        CHECK(snapshot.points[3 * i] == value);
        CHECK(snapshot.points[3 * i + 1] == 0.5f * value);
        CHECK(snapshot.points[3 * i + 2] == 10.0f + value);
        CHECK(snapshot.velocity[3 * i + 2] == -3.0f * value);
        CHECK(snapshot.damage[i] == doctest::Approx(0.2 * static_cast<double>(i)));
        CHECK(snapshot.id[i] == 100 - i);
        CHECK(snapshot.material[i] == (i == 0 ? 1 : 0));
        CHECK(snapshot.volume[i] == 0.25f);
        CHECK(std::isnan(snapshot.pressure[i]));
    }
    CHECK(snapshot.failure_time.empty());
}

std::vector<std::string> notes_of(const std::filesystem::path& path, const ParticleImport& import) {
    std::vector<std::string> notes;
    read_particle_file(path, import, &notes);
    return notes;
}

void write_ascii_vtp(const std::filesystem::path& path, const std::string& version) {
    write_text(path, "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"" + version +
                         R"(" byte_order="LittleEndian">
  <PolyData><Piece NumberOfPoints="2" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
    <Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0.5 0.25 0 1.5 0.75 0</DataArray></Points>
    <PointData>
      <DataArray type="Float64" Name="u" format="ascii">1 2</DataArray>
      <DataArray type="Float64" Name="v" format="ascii">3 4</DataArray>
    </PointData>
  </Piece></PolyData>
</VTKFile>
)");
}

}  // namespace

TEST_CASE("XML files of points are read, polydata and unstructured, in every encoding") {
    const TemporaryFolder folder;
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
        CAPTURE(mode);
        const auto set = [&](vtkXMLWriter* writer) { writer->SetDataMode(mode); };
        write<vtkXMLPolyDataWriter>(folder / "a.vtp", poly_data(), set);
        check_particles(read_particle_file(folder / "a.vtp", import_3d()));
        CHECK(read_particle_file(folder / "a.vtp", import_3d()).time == 1.5);
        CHECK(read_particle_time(folder / "a.vtp") == 1.5);
        write<vtkXMLUnstructuredGridWriter>(folder / "a.vtu", grid(), set);
        check_particles(read_particle_file(folder / "a.vtu", import_3d()));
        CHECK(read_particle_time(folder / "a.vtu") == 1.5);
    }
}

TEST_CASE("legacy files of points are read, polydata and unstructured, text and binary, of every version") {
    const TemporaryFolder folder;
    for (const int type : {VTK_ASCII, VTK_BINARY}) {
        for (const int version : {42, 51}) {
            CAPTURE(version);
            const auto set = [&](vtkDataWriter* writer) {
                writer->SetFileType(type);
                writer->SetFileVersion(version);
            };
            write<vtkPolyDataWriter>(folder / "a.vtk", poly_data(), set);
            check_particles(read_particle_file(folder / "a.vtk", import_3d()));
            write<vtkUnstructuredGridWriter>(folder / "b.vtk", grid(), set);
            check_particles(read_particle_file(folder / "b.vtk", import_3d()));
            CHECK(std::isnan(read_particle_time(folder / "b.vtk")));
        }
    }
}

TEST_CASE("VTKHDF files of points are read, with a time and without") {
    const TemporaryFolder folder;
    write_vtkhdf(folder / "a.vtkhdf", {1, 0}, 0);
    check_particles(read_particle_file(folder / "a.vtkhdf", import_3d()));
    CHECK(std::isnan(read_particle_time(folder / "a.vtkhdf")));
    write_vtkhdf(folder / "a.hdf", {2, 2}, 1);
    check_particles(read_particle_file(folder / "a.hdf", import_3d()));
    CHECK(read_particle_time(folder / "a.hdf") == 1.5);
}

TEST_CASE("our own snapshots and collections are read back as they are") {
    const TemporaryFolder folder;
    const Snapshot ours = test_snapshot_of_ice(1000);
    write_snapshot(folder / "frame_0000.hdf", ours, test_provenance());
    ParticleImport import;
    const Snapshot own = read_particle_file(folder / "frame_0000.hdf", import);
    CHECK(own.points == ours.points);
    CHECK(own.time == ours.time);
    CHECK(read_particle_time(folder / "frame_0000.hdf") == 1.25);
    CHECK(notes_of(folder / "frame_0000.hdf", import).empty());
    write_particles(folder / "particles_0000.vtp", ours, {}, test_provenance());
    const Snapshot collected = read_particle_file(folder / "particles_0000.vtp", import);
    for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        CHECK((collected.*column.values).size() == (ours.*column.values).size());
    });
    CHECK(collected.points == ours.points);
    CHECK(collected.velocity == ours.velocity);
    CHECK(collected.id == ours.id);
    CHECK(notes_of(folder / "particles_0000.vtp", import).empty());
}

TEST_CASE("what a file does not have is put in its place and told, where the caller knows it") {
    const TemporaryFolder folder;
    write<vtkXMLPolyDataWriter>(folder / "a.vtp", poly_data());
    ParticleImport import = import_3d("velocity=vel");
    import.material = Material::ice;
    const Snapshot snapshot = read_particle_file(folder / "a.vtp", import);
    CHECK(snapshot.material == std::vector<std::uint8_t>(count, 1));
    CHECK(snapshot.id == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
    CHECK(snapshot.damage.empty());
    const auto notes = notes_of(folder / "a.vtp", import);
    REQUIRE(notes.size() == 4);
    CHECK(notes[0].starts_with("no pressure in the files: "));
    CHECK(notes[1].starts_with("no volume in the files: 0.25 m³ for every particle"));
    CHECK(notes[2].starts_with("no material in the files: all is ice"));
    CHECK(notes[3].starts_with("no id in the files: "));
    import.material.reset();
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import);
          }).find("column material is missing") != std::string::npos);
    import = import_3d();
    import.volume = 0.0;
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import);
          }).find("column volume is missing") != std::string::npos);
}

TEST_CASE("a missing array is told with the file, the column and the arrays that there are") {
    const TemporaryFolder folder;
    write<vtkXMLPolyDataWriter>(folder / "a.vtp", poly_data());
    const std::string path = (folder / "a.vtp").string();
    CHECK(
        input_error([&] { read_particle_file(folder / "a.vtp", import_3d("id=Idp")); }) ==
        path +
            ": column velocity is missing; name one by --map velocity=ARRAY; its arrays are vel, D, Idp, Mk, "
            "w, state");
    CHECK(input_error([&] { read_particle_file(folder / "a.vtp", import_3d("velocity=v")); }) ==
          path +
              ": column velocity: there is no array v; name one by --map velocity=ARRAY; its arrays are vel, "
              "D, "
              "Idp, Mk, w, state");
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import_3d("velocity=vel,material=Mk,damage=state[4]"));
          }).find("array state has 4 components, counted from 0; there is no [4]") != std::string::npos);
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import_3d("velocity=D"));
          }).find("column velocity needs 3 components, not 1; name each") != std::string::npos);
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import_3d("velocity=vel,material=Mk,damage=vel"));
          }).find("column damage needs 1 components, not 3; name one") != std::string::npos);
}

TEST_CASE("numbers that stand for no material, id or value are refused") {
    const TemporaryFolder folder;
    write<vtkXMLPolyDataWriter>(folder / "a.vtp", poly_data());
    ParticleImport import = import_3d("velocity=vel,material=Mk");
    import.materials.clear();
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import);
          }).find("column material has the number 5, which stands for no material") != std::string::npos);
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import_3d("velocity=vel,material=Mk,id=D"));
          }).find("column id has the number 0.2; whole ones") != std::string::npos);
    CHECK(input_error([&] {
              read_particle_file(folder / "a.vtp", import_3d("velocity=nan,material=Mk"));
          }).find("column velocity has 15 values that are not numbers") != std::string::npos);
}

TEST_CASE("columns are made of components, of several arrays and of numbers") {
    const TemporaryFolder folder;
    write<vtkXMLPolyDataWriter>(folder / "a.vtp", poly_data());
    const Snapshot snapshot = read_particle_file(
        folder / "a.vtp",
        import_3d("velocity=vel[1]:0:w,damage=state[2],volume=2,material=rigid,pressure=5"));
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = static_cast<float>(i);
        CHECK(snapshot.velocity[3 * i] == 2.0f * value);
        CHECK(snapshot.velocity[3 * i + 1] == 0.0f);
        CHECK(snapshot.velocity[3 * i + 2] == 7.0f * value);
        CHECK(snapshot.damage[i] == doctest::Approx(0.1 * static_cast<double>(i)));
        CHECK(snapshot.volume[i] == 2.0f);
        CHECK(snapshot.pressure[i] == 5.0f);
        CHECK(snapshot.material[i] == 2);
    }
}

TEST_CASE("with y up the axes are turned and keep their hand, after the origin is moved") {
    const TemporaryFolder folder;
    write<vtkXMLPolyDataWriter>(folder / "a.vtp", poly_data());
    ParticleImport import = import_3d();
    import.y_up = true;
    import.origin = {1.0, 2.0, 3.0};
    const Snapshot snapshot = read_particle_file(folder / "a.vtp", import);
    CHECK(snapshot.points[3 * 4] == 3.0f);        // 4 - 1
    CHECK(snapshot.points[3 * 4 + 1] == -11.0f);  // -(14 - 3)
    CHECK(snapshot.points[3 * 4 + 2] == 0.0f);    // 2 - 2
    CHECK(snapshot.velocity[3 * 4 + 1] == 12.0f);
    CHECK(snapshot.velocity[3 * 4 + 2] == 8.0f);
}

TEST_CASE("2D data in the x-y plane, as written by hand in text, need to be told so") {
    const TemporaryFolder folder;
    write_ascii_vtp(folder / "a.vtp", "0.1");
    ParticleImport import;
    import.map = parse_column_map("velocity=u:v,material=water,volume=1");
    CHECK(input_error([&] { read_particle_file(folder / "a.vtp", import); }) ==
          (folder / "a.vtp").string() +
              ": its points reach from y = 0.25 to 0.75, but the scene is in 2D; if that axis is up, pass "
              "--up y");
    import.y_up = true;
    const Snapshot snapshot = read_particle_file(folder / "a.vtp", import);
    CHECK(snapshot.points == std::vector<float>{0.5f, 0.0f, 0.25f, 1.5f, 0.0f, 0.75f});
    CHECK(snapshot.velocity == std::vector<float>{1.0f, 0.0f, 3.0f, 2.0f, 0.0f, 4.0f});
    CHECK(std::isnan(snapshot.time));
}

TEST_CASE("meshes, grids and files of unknown kinds are refused") {
    const TemporaryFolder folder;
    const auto line = [&](const char* name) {
        return input_error([&] { read_particle_file(folder / name, import_3d()); });
    };
    write<vtkXMLUnstructuredGridWriter>(folder / "mesh.vtu", grid(VTK_TETRA, 4));
    CHECK(line("mesh.vtu").find("it holds a mesh, whose nodes are no particles") != std::string::npos);
    write_vtkhdf(folder / "mesh.hdf", {1, 0}, 0, VTK_TETRA);
    CHECK(line("mesh.hdf").find("it holds a mesh, whose nodes are no particles") != std::string::npos);
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 2);
    image->AllocateScalars(VTK_FLOAT, 1);
    write<vtkStructuredPointsWriter>(folder / "image.vtk", image);
    CHECK(line("image.vtk").find("a grid; particles are needed") != std::string::npos);
    write_vtkhdf(folder / "many.hdf", {2, 0}, 3);
    CHECK(line("many.hdf").find("it holds 3 times; write one file for each") != std::string::npos);
    write_text(folder / "a.csv", "x,y\n");
    CHECK(line("a.csv").find("its name ends like none of .vtp, .vtu") != std::string::npos);
    CHECK(line("none.vtp").find("the file does not exist") != std::string::npos);
}

TEST_CASE("files that are cut off, damaged or of a newer format are told in one line") {
    const TemporaryFolder folder;
    const auto check = [&](const char* name, const char* problem = ": ") {
        CAPTURE(name);
        const std::string line = input_error([&] { read_particle_file(folder / name, import_3d()); });
        CHECK(line.find(problem) != std::string::npos);
        CHECK(line.starts_with((folder / name).string() + ": "));
        CHECK(line.find('\n') == std::string::npos);
    };
    const auto cut = [&](const char* name, double share) {
        const auto size = static_cast<double>(std::filesystem::file_size(folder / name));
        std::filesystem::resize_file(folder / name, static_cast<std::uintmax_t>(share * size));
    };
    for (const double share : {0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05, 0.0}) {
        write<vtkXMLPolyDataWriter>(folder / "a.vtp", poly_data());
        write<vtkXMLUnstructuredGridWriter>(folder / "a.vtu", grid());
        write<vtkPolyDataWriter>(folder / "text.vtk", poly_data());
        write<vtkPolyDataWriter>(folder / "binary.vtk", poly_data(),
                                 [](vtkDataWriter* writer) { writer->SetFileTypeToBinary(); });
        write_vtkhdf(folder / "a.hdf", {1, 0}, 0);
        for (const char* name : {"a.vtp", "a.vtu", "a.hdf", "text.vtk", "binary.vtk"}) {
            cut(name, share);
            check(name);
        }
    }
    write_vtkhdf(folder / "newer.hdf", {3, 0}, 0);
    check("newer.hdf", "version 3 is newer than this program's 2");
    write_ascii_vtp(folder / "newer.vtp", "9.0");
    check("newer.vtp", "its format version 9 is newer than the 2 that is read");
    write<vtkPolyDataWriter>(folder / "newer.vtk", poly_data());
    std::string text = read_text(folder / "newer.vtk");
    text.replace(text.find("Version ") + 8, 1, "9");
    write_text(folder / "newer.vtk", text);
    check("newer.vtk", "its format version 9 is newer than the 5 that is read");
}

TEST_CASE("a file without particles is read as such") {
    const TemporaryFolder folder;
    vtkNew<vtkPolyData> nothing;
    nothing->SetPoints(vtkNew<vtkPoints>());
    write<vtkXMLPolyDataWriter>(folder / "a.vtp", nothing);
    ParticleImport import;
    import.map = parse_column_map("velocity=0,volume=1,material=water");
    CHECK(read_particle_file(folder / "a.vtp", import).particle_count() == 0);
}
