#include "io/vdb.h"

#include <doctest/doctest.h>

#include <openvdb/tools/LevelSetSphere.h>
#include <initializer_list>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

openvdb::FloatGrid::Ptr sphere() {
    openvdb::initialize();
    auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(1.0f, {0.0f, 0.0f, 0.0f}, 0.1f);
    grid->setName("water");
    return grid;
}

const Provenance provenance{"tidewater-geometry", "0", "test", "0123", 7};

}  // namespace

TEST_CASE("level sets come back with their names, values and metadata") {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "a.vdb";
    write_level_sets(file, {sphere()}, provenance);
    const auto grids = read_level_sets(file);
    REQUIRE(grids.size() == 1);
    CHECK(grids[0]->getName() == "water");
    CHECK(grids[0]->activeVoxelCount() == sphere()->activeVoxelCount());
    CHECK_FALSE(std::filesystem::exists(folder.path() / "a.vdb.part"));
}

TEST_CASE("the same level sets give the same bytes") {
    const test::TemporaryFolder folder;
    write_level_sets(folder.path() / "a.vdb", {sphere()}, provenance);
    write_level_sets(folder.path() / "b.vdb", {sphere()}, provenance);
    CHECK(read_text(folder.path() / "a.vdb") == read_text(folder.path() / "b.vdb"));
}

TEST_CASE("truncated, damaged, foreign and missing files are refused with a line") {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "a.vdb";
    write_level_sets(file, {sphere()}, provenance);
    const std::string whole = read_text(file);
    const auto expect = [&](const std::string& bytes, const char* words) {
        write_text(file, bytes);
        CAPTURE(words);
        CHECK_THROWS_WITH_AS(read_level_sets(file), doctest::Contains(words), InputError);
    };
    for (const std::size_t size : {whole.size() - 1, whole.size() / 2, std::size_t{200}}) {
        expect(whole.substr(0, size), size < 300 ? "a.vdb" : "truncated or damaged");
    }
    std::string damaged = whole;
    damaged[whole.size() / 2] ^= 1;
    expect(damaged, "truncated or damaged");
    expect("", "not an OpenVDB file");
    expect("solid block in STL", "not an OpenVDB file");
    openvdb::io::File(file.string()).write(openvdb::GridCPtrVec{sphere()});
    CHECK_THROWS_WITH_AS(read_level_sets(file), doctest::Contains("not one of tidewater-geometry"),
                         InputError);
    std::filesystem::remove(file);
    CHECK_THROWS_WITH_AS(read_level_sets(file), doctest::Contains("cannot be read"), InputError);
}
