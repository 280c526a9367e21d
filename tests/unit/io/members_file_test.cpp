#include "io/members_file.h"

#include <doctest/doctest.h>

#include "core/error.h"
#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

const Members three{.time = 2.5,
                    .given = 8,
                    .particle = {3, 4, 4000000000u},
                    .iceberg = {0, 7, 0},
                    .front = {400.0, 402.5},
                    .front_row = -2};

}  // namespace

TEST_CASE("members read back as they were written, none too") {
    const TemporaryFolder folder;
    const auto path = folder / "members_0000.h5";
    write_members(path, three, test_provenance());
    const Members read = read_members(path);
    CHECK(read.time == 2.5);
    CHECK(read.given == 8);
    CHECK(read.particle == three.particle);
    CHECK(read.iceberg == three.iceberg);
    CHECK(read.front == three.front);
    CHECK(read.front_row == -2);
    write_members(path, {}, test_provenance());
    CHECK(read_members(path).particle.empty());
    CHECK(read_members(path).front.empty());
}

TEST_CASE("equal members are equal bytes") {
    const TemporaryFolder folder;
    write_members(folder / "a.h5", three, test_provenance());
    write_members(folder / "b.h5", three, test_provenance());
    CHECK(read_text(folder / "a.h5") == read_text(folder / "b.h5"));
}

TEST_CASE("members that are missing, truncated or contradict themselves are told") {
    const TemporaryFolder folder;
    const auto path = folder / "members_0000.h5";
    CHECK_THROWS_AS(read_members(path), InputError);
    write_members(path, three, test_provenance());
    const std::string whole = read_text(path);
    write_text(path, whole.substr(0, whole.size() / 2));
    CHECK_THROWS_AS(read_members(path), InputError);
    Members wrong = three;
    wrong.given = 7;
    write_members(path, wrong, test_provenance());
    CHECK_THROWS_AS(read_members(path), InputError);
    wrong = three;
    wrong.particle = {3, 3, 4};
    write_members(path, wrong, test_provenance());
    CHECK_THROWS_AS(read_members(path), InputError);
}
