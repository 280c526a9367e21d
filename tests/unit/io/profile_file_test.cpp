#include "io/profile_file.h"

#include <doctest/doctest.h>

#include <string>

#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

const std::vector<double> x{-10.0, 0.5, 300.0}, z{-35.0, -36.5, 1.25};

std::string error_in(const std::string& text) {
    const TemporaryFolder folder;
    write_text(folder / "bed.csv", text);
    const std::string line = input_error([&] { read_profile(folder / "bed.csv"); });
    return line.substr(line.find("bed.csv"));
}

}  // namespace

TEST_CASE("a profile is read whatever separates its columns") {
    const TemporaryFolder folder;
    for (const std::string text :
         {"-10,-35\n0.5,-36.5\n300,1.25\n", "-10; -35\n0.5 ;-36.5\n3e2;1.25",
          "-10 -35\n\t0.5   -36.5\n300\t1.25\n",
          "# a fjord\n\nx (m), z (m)\n-10, -35 # the wall\r\n0.5, -36.5\r\n300, 1.25\r\n",
          "x z\n-10 -35\n0.5 -36.5\n#\n  \n300 1.25"}) {
        CAPTURE(text);
        write_text(folder / "bed.csv", text);
        const ProfileTable table = read_profile(folder / "bed.csv");
        CHECK(table.x == x);
        CHECK(table.z == z);
    }
}

TEST_CASE("a profile that is none is told by file and line") {
    CHECK(error_in("0, 1\n1, high\n").starts_with("bed.csv:2: \"high\" is not a number"));
    CHECK(error_in("0, 1\n1, nan\n").starts_with("bed.csv:2: \"nan\" is not a number"));
    CHECK(error_in("# c\nx, z\n0, 1\n\nx, z\n").starts_with("bed.csv:5: \"x\" is not a number"));
    CHECK(error_in("0, 1\n5, 2\n5, 3\n").starts_with("bed.csv:3: x = 5 m does not rise over the 5 m before"));
    CHECK(error_in("0 1\n5 2 9\n").starts_with("bed.csv:2: 3 values where a profile has two"));
    CHECK(error_in("0,5; 1,2\n").starts_with("bed.csv:1: 4 values"));
    CHECK(error_in("0, \n").starts_with("bed.csv:1: \"\" is not a number"));
    CHECK(error_in("0, 1\n").starts_with("bed.csv: a profile needs two points or more, and here are 1"));
    CHECK(error_in("").starts_with("bed.csv: a profile needs two points"));
    CHECK(input_error([] { read_profile("nowhere.csv"); }) ==
          "nowhere.csv: the file does not exist; check the path");
}
