#include "io/columns.h"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

#include "core/files.h"
#include "unit/io/fixture.h"

// The leak sanitizer's hook: HDF5 1.10 itself loses memory where it finds damage.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

using namespace tidewater;
using namespace tidewater::io;

namespace {

// A value of every kind that a state may hold.
struct State {
    std::vector<float> floats{0.1f, -0.0f, std::numeric_limits<float>::denorm_min()};
    std::vector<double> doubles{0.1, -std::numeric_limits<double>::infinity()};
    std::vector<std::int32_t> ints{-1, std::numeric_limits<std::int32_t>::min()};
    std::vector<std::uint32_t> unsigned_ints{4294967295u};
    std::vector<std::int64_t> longs{-1};
    std::vector<std::uint64_t> unsigned_longs{18446744073709551615ull};
    std::vector<Eigen::Vector2f> vectors{{1.0f, 2.0f}, {3.0f, 4.0f}};
    std::vector<Eigen::Vector3i> nodes{{1, -2, 3}};
    std::vector<Eigen::Matrix3d> matrices{Eigen::Matrix3d::Random(), Eigen::Matrix3d::Random()};
    std::vector<Eigen::Array<float, 4, 1>> arrays{{1.0f, 2.0f, 3.0f, 4.0f}};
    std::vector<double> none;
    std::vector<Eigen::Vector3f> no_vectors;
    double number = 1.0 / 3.0;
    long count = -7;
    std::uint64_t big = 1ull << 63;
    Eigen::Vector3d vector{1.0, 2.0, 3.0};
    std::string text{"two\nlines, \0 and ü", 20};
    std::string no_text;

    template <class Visit>
    void visit(const Visit& visit) {
        visit("floats", floats);
        visit("doubles", doubles);
        visit("ints", ints);
        visit("unsigned_ints", unsigned_ints);
        visit("longs", longs);
        visit("unsigned_longs", unsigned_longs);
        visit("vectors", vectors);
        visit("nodes", nodes);
        visit("matrices", matrices);
        visit("arrays", arrays);
        visit("none", none);
        visit("no_vectors", no_vectors);
        visit("number", number);
        visit("count", count);
        visit("big", big);
        visit("vector", vector);
        visit("text", text);
        visit("no_text", no_text);
    }
};

// Counts the values that differ between two states, element by element.
int differences(State& a, State& b) {
    const int total =
        (a.floats != b.floats) + (a.doubles != b.doubles) + (a.ints != b.ints) +
        (a.unsigned_ints != b.unsigned_ints) + (a.longs != b.longs) + (a.unsigned_longs != b.unsigned_longs) +
        (a.vectors != b.vectors) + (a.nodes != b.nodes) + (a.matrices != b.matrices) + (a.none != b.none) +
        (a.no_vectors != b.no_vectors) + (a.number != b.number) + (a.count != b.count) + (a.big != b.big) +
        (a.vector != b.vector) + (a.text != b.text) + (a.no_text != b.no_text);
    return total + ((a.arrays.size() != b.arrays.size() || (a.arrays[0] != b.arrays[0]).any()) ? 1 : 0);
}

State emptied() {
    State state;
    state.visit([](const std::string&, auto& value) {
        if constexpr (requires { value.clear(); })
            value.clear();
        else
            value *= 0;
    });
    state.none = {1.0};
    state.no_text = "not empty";
    return state;
}

void save(const std::filesystem::path& path, State& state) {
    Hdf5Writer file(path, Metadata::checksummed);
    file.attribute("/", "format", "tidewater-state");
    file.attribute("/", "format_version", std::array<std::int64_t, 1>{1});
    state.visit(ColumnWriter(file, "/state"));
    file.close();
}

void load(const std::filesystem::path& path, State& state) {
    const Hdf5Reader file(path, "remedy");
    file.require_format("state", 1);
    state.visit(ColumnReader(file, "/state"));
}

}  // namespace

TEST_CASE("values of every kind read back bit by bit") {
    const TemporaryFolder folder;
    State saved, loaded = emptied();
    save(folder / "a", saved);
    load(folder / "a", loaded);
    CHECK(differences(saved, loaded) == 0);
    CHECK(std::signbit(loaded.floats[1]));
}

TEST_CASE("equal states are equal bytes") {
    const TemporaryFolder folder;
    State state;
    state.matrices.assign(2, Eigen::Matrix3d::Identity());
    save(folder / "a", state);
    save(folder / "b", state);
    CHECK(read_text(folder / "a") == read_text(folder / "b"));
}

TEST_CASE("a flipped byte anywhere is found, or stands where nothing is read") {
    const TemporaryFolder folder;
    State state;
    save(folder / "a", state);
    const std::string good = read_text(folder / "a");
    int found = 0;
    for (std::size_t place = 0; place < good.size(); place += 7) {
        std::string bad = good;
        bad[place] = static_cast<char>(bad[place] ^ 0x20);
        write_text(folder / "b", bad);
        State loaded = emptied();
        const std::string line = input_error([&] { load(folder / "b", loaded); });
        if (line.empty()) CHECK_MESSAGE(differences(state, loaded) == 0, place);
        if (!line.empty()) ++found;
    }
    CHECK(found > 100);
}

TEST_CASE("a state that is cut short anywhere is refused") {
    const TemporaryFolder folder;
    State state;
    save(folder / "a", state);
    const std::string good = read_text(folder / "a");
    for (std::size_t size = 0; size < good.size(); size += 97) {
        write_text(folder / "b", good.substr(0, size));
        CHECK(input_error([&] { load(folder / "b", state); }).find("truncated or no HDF5 file") !=
              std::string::npos);
    }
}

TEST_CASE("a value that is missing, or of another type, shape or number is named") {
    const TemporaryFolder folder;
    State state;
    save(folder / "a", state);
    const Hdf5Reader file(folder / "a", "remedy");
    const ColumnReader reader(file, "/state");
    const auto line = [&](const std::string& name, auto value) {
        const std::string whole = input_error([&] { reader(name, value); });
        return whole.substr(0, whole.find("; remedy")).substr((folder / "a").string().size());
    };
    CHECK(line("other", 1.0) == ": array /state/other is missing");
    CHECK(line("floats", std::vector<double>()) == ": array /state/floats holds numbers of another type");
    CHECK(line("ints", std::vector<std::uint32_t>()) == ": array /state/ints holds numbers of another type");
    CHECK(line("floats", 1.0f) == ": array /state/floats holds 3 values instead of 1");
    CHECK(line("floats", std::vector<Eigen::Vector2f>()) == ": array /state/floats has an unexpected shape");
    CHECK(line("vectors", std::vector<Eigen::Vector3f>()) ==
          ": array /state/vectors does not have 3 components");
    CHECK(line("number", std::string()) == ": array /state/number holds numbers of another type");
}

TEST_CASE("a state of a newer format or of another kind is refused") {
    const TemporaryFolder folder;
    State state;
    save(folder / "a", state);
    const Hdf5Reader file(folder / "a", "remedy");
    CHECK(input_error([&] { file.require_format("state", 0); }) ==
          (folder / "a").string() + ": its format version 1 is newer than this program's 0; remedy");
    CHECK(input_error([&] { file.require_format("snapshot", 1); }) ==
          (folder / "a").string() + ": it is an HDF5 file but no tidewater snapshot; remedy");
}

TEST_CASE("a file that cannot be completed is an output error") {
    State state;
    CHECK_THROWS_AS(save("/dev/full", state), OutputError);
    CHECK_THROWS_AS(save("/nowhere/a", state), OutputError);
}
