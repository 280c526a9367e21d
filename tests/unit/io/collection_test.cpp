#include "io/collection.h"

#include <doctest/doctest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "core/files.h"
#include "io/canvas.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

vtkSmartPointer<vtkPolyData> read(const std::filesystem::path& path) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

}  // namespace

TEST_CASE("VTK reads back the points, the cell, every column and the speed") {
    const TemporaryFolder folder;
    const Snapshot snapshot = test_snapshot(50);
    write_particles(folder / particles_name(3), snapshot, {}, test_provenance());
    const auto data = read(folder / "particles_0003.vtp");
    CHECK(data->GetNumberOfPoints() == 50);
    CHECK(data->GetNumberOfCells() == 1);
    CHECK(data->GetCellType(0) == VTK_POLY_VERTEX);
    CHECK(data->GetBounds()[5] == doctest::Approx(2.0 + 0.25 * 49.0));
    for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        if (column.optional) return;
        vtkDataArray* array = data->GetPointData()->GetArray(column.name);
        REQUIRE(array != nullptr);
        const auto& values = snapshot.*column.values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto point = static_cast<vtkIdType>(i) / column.components;
            const auto component = static_cast<int>(i) % column.components;
            CHECK(array->GetComponent(point, component) == static_cast<double>(values[i]));
        }
    });
    CHECK(data->GetPointData()->GetArray("velocity_magnitude")->GetComponent(10, 0) == 50.0);
    const auto field = [&](const char* name) {
        return std::string(data->GetFieldData()->GetAbstractArray(name)->GetVariantValue(0).ToString());
    };
    CHECK(field("scene_hash") == "00ff");
    CHECK(field("format") == "tidewater-particles");
    CHECK(field("format_version") == "1");
}

TEST_CASE("optional columns are there if the snapshot has them, gaps included") {
    const TemporaryFolder folder;
    write_particles(folder / "ice.vtp", test_snapshot_of_ice(50), {}, test_provenance());
    write_particles(folder / "water.vtp", test_snapshot(50), {}, test_provenance());
    CHECK(read(folder / "water.vtp")->GetPointData()->GetArray("damage") == nullptr);
    const auto data = read(folder / "ice.vtp");
    CHECK(data->GetPointData()->GetArray("damage")->GetComponent(1, 0) == 0.25);
    CHECK(data->GetPointData()->GetArray("failure_time")->GetComponent(48, 0) == 0.5);
    CHECK(std::isnan(data->GetPointData()->GetArray("failure_time")->GetComponent(49, 0)));
}

TEST_CASE("data is inline, for appended data does not open in ParaView 5.11") {
    const TemporaryFolder folder;
    write_particles(folder / "a.vtp", test_snapshot(10), {}, test_provenance());
    const std::string text = read_text(folder / "a.vtp");
    CHECK(text.find("format=\"binary\"") != std::string::npos);
    CHECK(text.find("appended") == std::string::npos);
    CHECK(text.find("vtkLZ4DataCompressor") != std::string::npos);
    write_particles(folder / "b.vtp", test_snapshot(10), {}, test_provenance());
    CHECK(text == read_text(folder / "b.vtp"));
}

TEST_CASE("no particles make a file without points or cells") {
    const TemporaryFolder folder;
    write_particles(folder / "a.vtp", test_snapshot(0), {}, test_provenance());
    CHECK(read(folder / "a.vtp")->GetNumberOfPoints() == 0);
    CHECK(read(folder / "a.vtp")->GetNumberOfCells() == 0);
}

TEST_CASE("a folder that is not there gives an error, and no file") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(write_particles(folder / "no/a.vtp", test_snapshot(1), {}, test_provenance()),
                    OutputError);
    CHECK(folder.file_count() == 0);
}

TEST_CASE("a full disk gives an error, and no file") {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "a.vtp.part");
    std::filesystem::create_symlink("/dev/full", folder / "a.png.part");
    CHECK_THROWS_AS(write_particles(folder / "a.vtp", test_snapshot(1000), {}, test_provenance()),
                    OutputError);
    CHECK_THROWS_AS(Canvas(300, 300).write_png(folder / "a.png", test_provenance()), OutputError);
    CHECK(folder.file_count() == 0);
}

TEST_CASE("a disk that is full after half of a file gives an error, and no file") {
    const TemporaryFolder folder;
    rlimit before{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    for (const rlim_t most : {rlim_t{1000}, rlim_t{200000}, rlim_t{1000000}}) {
        const rlimit small{most, before.rlim_max};
        REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
        CHECK_THROWS_AS(write_particles(folder / "a.vtp", test_snapshot(50000), {}, test_provenance()),
                        OutputError);
        REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
    }
    std::signal(SIGXFSZ, handler);
    CHECK(folder.file_count() == 0);
    write_particles(folder / "a.vtp", test_snapshot(50000), {}, test_provenance());
    CHECK(read(folder / "a.vtp")->GetNumberOfPoints() == 50000);
}

TEST_CASE("derived columns are there if they are not empty") {
    const TemporaryFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    write_particles(folder / "a.vtp", test_snapshot(3), {{}, {1e6f, nan, 0.0f}, {7, 0, 2}},
                    test_provenance());
    const auto particles = read(folder / "a.vtp");
    vtkPointData* data = particles->GetPointData();
    CHECK(data->GetArray("alpha") == nullptr);
    CHECK(data->GetArray("p0")->GetComponent(0, 0) == 1e6);
    CHECK(std::isnan(data->GetArray("p0")->GetComponent(1, 0)));
    CHECK(data->GetArray("iceberg")->GetDataType() == VTK_INT);
    CHECK(data->GetArray("iceberg")->GetComponent(2, 0) == 2.0);
}

TEST_CASE("thinned out, each frame keeps the same particles with all they have") {
    Snapshot snapshot = test_snapshot_of_ice(9000);
    const Snapshot kept = thin_out(snapshot, 10);
    CHECK(kept.time == snapshot.time);
    CHECK(kept.particle_count() > 800);
    CHECK(kept.particle_count() < 1000);
    CHECK(kept.velocity.size() == 3 * kept.particle_count());
    CHECK(kept.alpha.size() == kept.particle_count());
    for (std::size_t p = 0; p < kept.particle_count(); ++p) {
        const std::size_t from = kept.id[p] / 7;  // the fixture's number
        CHECK(kept.points[3 * p + 2] == snapshot.points[3 * from + 2]);
        CHECK(kept.velocity[3 * p + 2] == snapshot.velocity[3 * from + 2]);
        CHECK(kept.damage[p] == snapshot.damage[from]);
    }
    // The order of particles, and what has left, do not matter.
    std::reverse(snapshot.id.begin(), snapshot.id.end());
    std::vector<std::uint32_t> again = thin_out(snapshot, 10).id;
    std::reverse(again.begin(), again.end());
    CHECK(again == kept.id);
    CHECK(thin_out(snapshot, 1).particle_count() == 9000);
    CHECK(thin_out(snapshot, 0).particle_count() == 0);
    CHECK(thin_out(test_snapshot(0), 3).particle_count() == 0);
}

TEST_CASE("the collection names every file with its time") {
    const TemporaryFolder folder;
    write_collection(folder / "particles.pvd", {{"particles_0000.vtp", 0.0}, {"particles_0001.vtp", 0.1}},
                     test_provenance());
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
        vtkXMLUtilities::ReadElementFromFile((folder / "particles.pvd").c_str()));
    REQUIRE(root);
    CHECK(std::string(root->GetAttribute("type")) == "Collection");
    vtkXMLDataElement* second = root->GetNestedElement(0)->GetNestedElement(1);
    CHECK(std::string(second->GetAttribute("file")) == "particles_0001.vtp");
    CHECK(std::string(second->GetAttribute("timestep")) == "0.1");
}

TEST_CASE("the collection's provenance is a comment that XML allows") {
    const TemporaryFolder folder;
    Provenance provenance = test_provenance();
    provenance.command = "tidewater-test --set a=---1 --";
    write_collection(folder / "a.pvd", {{"particles_0000.vtp", 0.0}}, provenance);
    const std::string text = read_text(folder / "a.pvd");
    CHECK(text.find("scene_hash: 00ff\n") != std::string::npos);
    CHECK(text.find("command: tidewater-test - -set a=- - -1 - -\n") != std::string::npos);
    CHECK(vtkSmartPointer<vtkXMLDataElement>::Take(
        vtkXMLUtilities::ReadElementFromFile((folder / "a.pvd").c_str())));
}
