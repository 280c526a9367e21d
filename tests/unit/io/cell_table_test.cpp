#include "io/cell_table.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

TEST_CASE("words and numbers of a table are found by column and row") {
    const TemporaryFolder folder;
    write_text(folder / "a.csv", "# format: tidewater-table 1\nx,source,crest\n1,run,0.5\nnan,all,\n");
    const CellTable table = read_cells(folder / "a.csv");
    REQUIRE(table.rows.size() == 2);
    CHECK(table.number(0, "crest") == 0.5);
    CHECK(table.word(1, "source") == "all");
    CHECK(std::isnan(table.number(1, "x")));
    CHECK(std::isnan(table.number(1, "crest")));
    CHECK(std::isnan(table.number(0, "source")));
    CHECK(std::isnan(table.number(0, "nothing")));
    CHECK(table.word(2, "source").empty());
    CHECK(table.index("nothing") == 3);
}

TEST_CASE("a table without rows is one, a row of the wrong length is told with its line") {
    const TemporaryFolder folder;
    write_text(folder / "a.csv", "a,b\n");
    CHECK(read_cells(folder / "a.csv").rows.empty());
    write_text(folder / "b.csv", "# comment\na,b\n1,2\n3\n");
    CHECK(input_error([&] { read_cells(folder / "b.csv"); }).find("b.csv:4: 1 values instead of 2") !=
          std::string::npos);
    write_text(folder / "c.csv", "# comment\n");
    CHECK(input_error([&] { read_cells(folder / "c.csv"); }).find("c.csv: no line of column names") !=
          std::string::npos);
}
