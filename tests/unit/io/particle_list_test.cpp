#include "io/particle_list.h"

#include <doctest/doctest.h>

#include "core/files.h"
#include "io/collection.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

// Legacy files, which tell no time.
void write_timeless(const TemporaryFolder& folder, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        write_text(folder / name,
                   "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n");
    }
}

std::vector<std::string> names_of(const ParticleList& list) {
    std::vector<std::string> names;
    for (const auto& file : list.files) names.push_back(file.filename());
    return names;
}

}  // namespace

TEST_CASE("files without times are in the order of the numbers in their names, which is told") {
    const TemporaryFolder folder;
    write_timeless(folder, {"out_10.vtk", "out_2.vtk", "out_009.vtk"});
    const ParticleList list =
        list_particles({folder / "out_10.vtk", folder / "out_2.vtk", folder / "out_009.vtk"}, {});
    CHECK(names_of(list) == std::vector<std::string>{"out_2.vtk", "out_009.vtk", "out_10.vtk"});
    CHECK(list.times == std::vector<double>{0.0, 1.0, 2.0});
    CHECK(list.note.find("--times") != std::string::npos);
}

TEST_CASE("times that are told count before the files' own, one for each file as named") {
    const TemporaryFolder folder;
    write_timeless(folder, {"a.vtk", "b.vtk"});
    const ParticleList list = list_particles({folder / "a.vtk", folder / "b.vtk"}, {2.5, 0.5});
    CHECK(names_of(list) == std::vector<std::string>{"b.vtk", "a.vtk"});
    CHECK(list.times == std::vector<double>{0.5, 2.5});
    CHECK(list.note.empty());
    CHECK(input_error([&] {
              list_particles({folder / "a.vtk"}, {1.0, 2.0});
          }) == "--times: 2 times for 1 files; tell one for each");
}

TEST_CASE("our own frames tell their times, in whatever order they are named") {
    const TemporaryFolder folder;
    Snapshot snapshot = test_snapshot(3);
    for (const double time : {4.0, 0.5}) {
        snapshot.time = time;
        write_snapshot(folder / (time > 1.0 ? "frame_0000.hdf" : "frame_0001.hdf"), snapshot,
                       test_provenance());
    }
    const ParticleList list = list_particles({folder / "frame_0000.hdf", folder / "frame_0001.hdf"}, {});
    CHECK(names_of(list) == std::vector<std::string>{"frame_0001.hdf", "frame_0000.hdf"});
    CHECK(list.times == std::vector<double>{0.5, 4.0});
}

TEST_CASE("collections name files beside them, with times") {
    const TemporaryFolder folder;
    write_timeless(folder, {"a.vtk", "b.vtk"});
    write_collection(folder / "all.pvd", {{"b.vtk", 0.25}, {"a.vtk", 0.75}}, test_provenance());
    write_text(folder / "all.vtk.series", R"({"file-series-version": "1.0", "files": [
        {"name": "b.vtk", "time": 0.25}, {"name": "a.vtk", "time": 0.75}]})");
    for (const char* name : {"all.pvd", "all.vtk.series"}) {
        CAPTURE(name);
        const ParticleList list = list_particles({folder / name}, {});
        CHECK(names_of(list) == std::vector<std::string>{"b.vtk", "a.vtk"});
        CHECK(list.times == std::vector<double>{0.25, 0.75});
        CHECK(list.note.empty());
    }
}

TEST_CASE("what is missing, cut off, empty or of the same time is told with the file") {
    const TemporaryFolder folder;
    write_timeless(folder, {"a.vtk"});
    const auto line = [&](const char* name) {
        return input_error([&] { list_particles({folder / name}, {}); });
    };
    CHECK(line("none.vtk") == (folder / "none.vtk").string() + ": the file does not exist; check the path");
    CHECK(line("none.pvd") == (folder / "none.pvd").string() + ": the file does not exist; check the path");
    write_collection(folder / "all.pvd", {{"none.vtk", 0.0}}, test_provenance());
    CHECK(line("all.pvd").find("none.vtk: the file does not exist") != std::string::npos);
    write_text(folder / "all.pvd", "<VTKFile><Collection>");
    CHECK(line("all.pvd").find("truncated") != std::string::npos);
    write_collection(folder / "all.pvd", {}, test_provenance());
    CHECK(line("all.pvd").find("it names no files") != std::string::npos);
    write_text(folder / "a.vtk.series", "{\"files\": [");
    CHECK(line("a.vtk.series").find("truncated") != std::string::npos);
    write_collection(folder / "all.pvd", {{"a.vtk", 1.0}, {"a.vtk", 1.0}}, test_provenance());
    CHECK(line("all.pvd").find("two files are of the time 1") != std::string::npos);
    CHECK(input_error([&] {
              list_particles({folder / "a.vtk", folder / "a.vtk"}, {1.0, 1.0});
          }).find("it is of the same time, 1 s, as ") != std::string::npos);
}
