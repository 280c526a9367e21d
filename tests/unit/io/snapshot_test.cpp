#include "io/snapshot.h"

#include <doctest/doctest.h>

#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <limits>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "core/files.h"
#include "io/hdf5_file.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

void check_equal(const Snapshot& a, const Snapshot& b) {
    CHECK(a.time == b.time);
    CHECK(a.dimension == b.dimension);
    CHECK(a.points == b.points);
    for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        CHECK(std::ranges::equal(a.*column.values, b.*column.values,
                                 [](auto x, auto y) { return x == y || (x != x && y != y); }));
    });
}

void cut(const std::filesystem::path& path, std::size_t bytes) {
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - bytes);
}

// Replaces the attribute format_version and the names of the arrays by those of another program.
void write_foreign(const std::filesystem::path& path, const char* format, std::int64_t version) {
    Hdf5Writer file(path);
    if (format) file.attribute("/", "format", format);
    file.attribute("/", "format_version", std::array{version});
    file.attribute("/", "time", 0.0);
    file.attribute("/", "dimension", std::array<std::int64_t, 1>{2});
    file.close();
}

}  // namespace

TEST_CASE("reads back what was written, for none, one and many particles") {
    const TemporaryFolder folder;
    for (const std::size_t count : {0u, 1u, 1000u, 200000u}) {
        const Snapshot snapshot = test_snapshot(count);
        write_snapshot(folder / "frame_0000.hdf", snapshot, test_provenance());
        check_equal(read_snapshot(folder / "frame_0000.hdf"), snapshot);
        CHECK(read_snapshot_time(folder / "frame_0000.hdf") == 1.25);
    }
    CHECK(folder.file_count() == 1);
}

TEST_CASE("VTK's own reader sees the points, the bounds and every array") {
    const TemporaryFolder folder;
    write_snapshot(folder / "frame_0000.hdf", test_snapshot(101), test_provenance());
    vtkNew<vtkHDFReader> reader;
    reader->SetFileName((folder / "frame_0000.hdf").c_str());
    reader->Update();
    auto* grid = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
    REQUIRE(grid != nullptr);
    CHECK(grid->GetNumberOfPoints() == 101);
    CHECK(grid->GetNumberOfCells() == 1);
    CHECK(grid->GetCellType(0) == VTK_POLY_VERTEX);
    CHECK(grid->GetCell(0)->GetNumberOfPoints() == 101);
    const std::array<double, 6> expected{0.0, 50.0, 0.0, 0.0, 2.0, 27.0};
    for (int i = 0; i < 6; ++i) CHECK(grid->GetBounds()[i] == expected[static_cast<std::size_t>(i)]);
    for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        if (column.optional) return;
        vtkDataArray* array = grid->GetPointData()->GetArray(column.name);
        REQUIRE(array != nullptr);
        CHECK(array->GetNumberOfTuples() == 101);
        CHECK(array->GetNumberOfComponents() == column.components);
    });
    CHECK(grid->GetPointData()->GetArray("velocity")->GetComponent(10, 2) == -40.0);
    CHECK(grid->GetPointData()->GetArray("id")->GetComponent(100, 0) == 700.0);
}

TEST_CASE("optional columns are in the file if the snapshot has them, gaps included") {
    const TemporaryFolder folder;
    for (const std::size_t count : {1u, 1000u}) {
        const Snapshot ice = test_snapshot_of_ice(count);
        write_snapshot(folder / "ice", ice, test_provenance());
        check_equal(read_snapshot(folder / "ice"), ice);
    }
    write_snapshot(folder / "water", test_snapshot(1000), test_provenance());
    CHECK(read_snapshot(folder / "water").damage.empty());
    CHECK(!Hdf5Reader(folder / "water", "").has_array("/VTKHDF/PointData/failure_time"));
    CHECK(Hdf5Reader(folder / "ice", "").has_array("/VTKHDF/PointData/failure_time"));

    vtkNew<vtkHDFReader> reader;
    reader->SetFileName((folder / "ice").c_str());
    reader->Update();
    vtkDataArray* time =
        vtkUnstructuredGrid::SafeDownCast(reader->GetOutput())->GetPointData()->GetArray("failure_time");
    REQUIRE(time != nullptr);
    CHECK(time->GetComponent(4, 0) == 0.5);
    CHECK(std::isnan(time->GetComponent(5, 0)));
}

TEST_CASE("optional columns of the wrong length or with what is not a number are refused") {
    const TemporaryFolder folder;
    Snapshot snapshot = test_snapshot_of_ice(8);
    snapshot.damage.pop_back();
    CHECK_THROWS_AS(write_snapshot(folder / "a", snapshot, test_provenance()), std::invalid_argument);
    snapshot.damage.push_back(std::numeric_limits<float>::quiet_NaN());
    write_snapshot(folder / "a", snapshot, test_provenance());
    CHECK(input_error([&] { read_snapshot(folder / "a"); }).find("damage has 1 values") != std::string::npos);
    snapshot.damage.back() = 0.0f;
    snapshot.failure_time.back() = std::numeric_limits<float>::infinity();
    write_snapshot(folder / "a", snapshot, test_provenance());
    CHECK(input_error([&] { read_snapshot(folder / "a"); }).find("failure_time has 1") != std::string::npos);
}

TEST_CASE("equal snapshots are equal bytes, and another time is not") {
    const TemporaryFolder folder;
    Snapshot snapshot = test_snapshot(70000);
    write_snapshot(folder / "a", snapshot, test_provenance());
    write_snapshot(folder / "b", snapshot, test_provenance());
    CHECK(read_text(folder / "a") == read_text(folder / "b"));
    snapshot.time = 2.0;
    write_snapshot(folder / "b", snapshot, test_provenance());
    CHECK(read_text(folder / "a") != read_text(folder / "b"));
}

TEST_CASE("carries the provenance") {
    const TemporaryFolder folder;
    write_snapshot(folder / "a", test_snapshot(3), test_provenance());
    const Hdf5Reader file(folder / "a", "");
    for (const auto& [name, text] : provenance_fields(test_provenance())) CHECK(file.text("/", name) == text);
}

TEST_CASE("refuses columns of the wrong length, and leaves no file") {
    const TemporaryFolder folder;
    Snapshot snapshot = test_snapshot(4);
    snapshot.pressure.pop_back();
    CHECK_THROWS_AS(write_snapshot(folder / "a", snapshot, test_provenance()), std::invalid_argument);
    CHECK(folder.file_count() == 0);
    CHECK_THROWS_AS(write_snapshot(folder / "no/a", test_snapshot(4), test_provenance()), OutputError);
}

TEST_CASE("a missing, truncated or foreign file gives one line with the file, the problem and the remedy") {
    const TemporaryFolder folder;
    const auto path = folder / "frame_0000.hdf";
    const auto line = [&] { return input_error([&] { read_snapshot(path); }); };
    const std::string remedy = "; run tidewater-simulate again";
    CHECK(line() == path.string() + ": the file does not exist" + remedy);

    write_snapshot(path, test_snapshot(1000), test_provenance());
    cut(path, 100);
    CHECK(line() == path.string() + ": it is truncated or no HDF5 file" + remedy);
    write_text(path, "particles: 3");
    CHECK(line() == path.string() + ": it is truncated or no HDF5 file" + remedy);
    write_text(path, "");
    CHECK(line() == path.string() + ": it is truncated or no HDF5 file" + remedy);

    write_foreign(path, nullptr, 1);
    CHECK(line() == path.string() + ": it is an HDF5 file but no tidewater snapshot" + remedy);
    write_foreign(path, "other", 1);
    CHECK(line() == path.string() + ": it is an HDF5 file but no tidewater snapshot" + remedy);
    write_foreign(path, "tidewater-snapshot", 99);
    CHECK(line() == path.string() + ": its format version 99 is newer than this program's 1" + remedy);
    write_foreign(path, "tidewater-snapshot", 1);
    CHECK(line() == path.string() + ": array /VTKHDF/Points is missing" + remedy);
}

TEST_CASE("attributes of another shape or kind give an error instead of being read") {
    const TemporaryFolder folder;
    Hdf5Writer writer(folder / "a.hdf");
    writer.attribute("/", "many", std::vector<std::int64_t>(1000, 7));
    writer.attribute("/", "text", "seven");
    writer.attribute("/", "real", 7.5);
    writer.close();
    const Hdf5Reader file(folder / "a.hdf", "remedy");
    const std::string many = "attribute many does not hold one value";
    CHECK(input_error([&] { file.number("/", "many"); }).find(many) != std::string::npos);
    CHECK(input_error([&] { file.integer("/", "many"); }).find(many) != std::string::npos);
    CHECK(input_error([&] { file.text("/", "many"); }).find(many) != std::string::npos);
    CHECK(input_error([&] { file.number("/", "text"); }).find("is not a number") != std::string::npos);
    CHECK(input_error([&] { file.integer("/", "real"); }).find("is no integer") != std::string::npos);
    CHECK(input_error([&] { file.text("/", "real"); }).find("is no fixed-size text") != std::string::npos);
}

TEST_CASE("a flipped byte in the particles is found by its checksum") {
    const TemporaryFolder folder;
    const auto path = folder / "frame_0000.hdf";
    Snapshot snapshot = test_snapshot(100);
    std::fill(snapshot.pressure.begin(), snapshot.pressure.end(), 12345.678f);
    write_snapshot(path, snapshot, test_provenance());
    std::string bytes = read_text(path);
    const float pressure = 12345.678f;
    const auto place = bytes.find(std::string(reinterpret_cast<const char*>(&pressure), sizeof pressure));
    REQUIRE(place != std::string::npos);
    bytes[place] = static_cast<char>(bytes[place] ^ 1);
    write_text(path, bytes);
    CHECK(input_error([&] { read_snapshot(path); }).find("pressure is damaged") != std::string::npos);
}

TEST_CASE("lists the snapshots of a folder by number, and nothing else") {
    const TemporaryFolder folder;
    for (const char* name : {"frame_0003.hdf.part", "frame_.hdf", "frame_x.hdf", "frame_1.hdf",
                             "frame.hdf.series", "other.hdf"}) {
        write_text(folder / name, "");
    }
    constexpr std::size_t count = 10002;  // so that the last names are longer
    for (std::size_t frame = 0; frame < count; ++frame) std::ofstream(folder / snapshot_name(frame));
    const auto found = list_snapshots(folder.path());
    REQUIRE(found.size() == count);
    for (std::size_t frame = 0; frame < count; ++frame) {
        REQUIRE(found[frame].filename() == snapshot_name(frame));
    }
    CHECK(input_error([&] { list_snapshots(folder / "none"); }).find("run tidewater-simulate first") !=
          std::string::npos);
}

TEST_CASE("names the first snapshot that is missing among others") {
    const TemporaryFolder folder;
    const auto line = [&] { return input_error([&] { list_snapshots(folder.path()); }); };
    for (const std::size_t frame : {1u, 3u}) write_text(folder / snapshot_name(frame), "");
    CHECK(line().starts_with((folder / "frame_0000.hdf").string() + ": the file is missing"));
    write_text(folder / snapshot_name(0), "");
    CHECK(line().starts_with((folder / "frame_0002.hdf").string() + ": the file is missing"));
}

TEST_CASE("a snapshot with places that are not numbers is refused") {
    const TemporaryFolder folder;
    Snapshot snapshot = test_snapshot(4);
    snapshot.points[3] = std::numeric_limits<float>::quiet_NaN();
    write_snapshot(folder / "frame_0000.hdf", snapshot, test_provenance());
    CHECK_THROWS_WITH_AS(read_snapshot(folder / "frame_0000.hdf"),
                         doctest::Contains("1 values that are not numbers"), InputError);
}

TEST_CASE("the series names every frame with its time") {
    const TemporaryFolder folder;
    write_series(folder.path(), {0.0, 0.1});
    CHECK(read_text(folder / "frame.hdf.series") ==
          "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n"
          "    {\"name\": \"frame_0000.hdf\", \"time\": 0},\n"
          "    {\"name\": \"frame_0001.hdf\", \"time\": 0.1}\n  ]\n}\n");
}
