#include "io/table.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "io/text.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

TEST_CASE("numbers read back to the same value, not-a-number included") {
    const TemporaryFolder folder;
    const std::vector<double> hard{0.1, 1.0 / 3.0, -0.0, 1e-310, 1.7976931348623157e308, 123456789.123456789};
    TableWriter writer(folder / "a.csv", test_provenance(), {"time", "x=2"});
    for (const double value : hard) writer.append(std::array{value, std::nan("")});
    writer.finish();
    const Table table = read_table(folder / "a.csv");
    CHECK(table.columns == std::vector<std::string>{"time", "x=2"});
    CHECK(table.values[0] == hard);
    CHECK(table.row_count() == hard.size());
    for (const double value : *table.find("x=2")) CHECK(std::isnan(value));
    CHECK(table.find("x=3") == nullptr);
}

TEST_CASE("leads with the provenance as comments, then the names, then the rows") {
    const TemporaryFolder folder;
    TableWriter writer(folder / "a.csv", test_provenance(), {"time", "source"});
    writer.append_cells(std::array<std::string, 2>{format_number(0.5), "run"});
    writer.finish();
    CHECK(read_text(folder / "a.csv") ==
          "# format: tidewater-table 1\n# program: tidewater-test\n# version: 1.2.3\n# command: "
          "tidewater-test a.toml\n# scene_hash: 00ff\n"
          "# seed: 7\ntime,source\n0.5,run\n");
}

TEST_CASE("grows under its .part name, row by row, and leaves nothing if it is not finished") {
    const TemporaryFolder folder;
    {
        TableWriter writer(folder / "a.csv", test_provenance(), {"time"});
        writer.append(std::array{1.0});
        CHECK(read_table(folder / "a.csv.part").row_count() == 1);
        CHECK_THROWS_AS(writer.append(std::array{1.0, 2.0}), std::invalid_argument);
        CHECK_FALSE(std::filesystem::exists(folder / "a.csv"));
    }
    CHECK(folder.file_count() == 0);
}

TEST_CASE("of a table that still grows the rows count that are whole") {
    const TemporaryFolder folder;
    write_text(folder / "a.csv.part", "time,x\n0,1\n0.5,2\n1,");
    const Table table = read_table(folder / "a.csv.part");
    CHECK(table.values[0] == std::vector<double>{0.0, 0.5});
    CHECK(table.values[1] == std::vector<double>{1.0, 2.0});
    write_text(folder / "a.csv.part", "time,x\n0,1\n0.5,2\n1,3");  // 3 may be the start of 35
    CHECK(read_table(folder / "a.csv.part").row_count() == 2);
    write_text(folder / "a.csv", "time,x\n0,1\n0.5,");
    CHECK(input_error([&] { read_table(folder / "a.csv"); }).find("a.csv:3: ") != std::string::npos);
}

TEST_CASE("a table that goes on behind an earlier one's text is the same as one written at once") {
    const TemporaryFolder folder;
    TableWriter whole(folder / "whole.csv", test_provenance(), {"time", "x=2"});
    whole.append(std::array{0.0, 0.1});
    const std::string text = whole.text();
    whole.append(std::array{1.0, 0.2});
    CHECK(whole.text().size() > text.size());
    whole.finish();

    TableWriter pieces(folder / "pieces.csv", test_provenance(), {"time", "x=2"});
    pieces.append(std::array{7.0, 7.0});
    pieces.resume(text);
    CHECK(pieces.text() == text);
    pieces.append(std::array{1.0, 0.2});
    pieces.finish();
    CHECK(read_text(folder / "pieces.csv") == read_text(folder / "whole.csv"));
}

TEST_CASE("a part that is kept can be read") {
    const TemporaryFolder folder;
    {
        TableWriter writer(folder / "a.csv", test_provenance(), {"time"});
        writer.append(std::array{1.0});
        writer.keep_part();
    }
    CHECK(read_table(folder / "a.csv.part").row_count() == 1);
}

TEST_CASE("a table may have no rows") {
    const TemporaryFolder folder;
    write_text(folder / "a.csv", "# a comment\n\ntime,x=2\n");
    const Table table = read_table(folder / "a.csv");
    CHECK(table.row_count() == 0);
    CHECK(table.values.size() == 2);
}

TEST_CASE("accepts the line ends and blanks of other programs") {
    const TemporaryFolder folder;
    write_text(folder / "a.csv", "time,value\r\n 1 , 2.5\r\n3,-4e1");
    const Table table = read_table(folder / "a.csv");
    CHECK(table.values == std::vector<std::vector<double>>{{1.0, 3.0}, {2.5, -40.0}});
}

TEST_CASE("a bad row gives one line with the file, the line and the problem") {
    const TemporaryFolder folder;
    const auto path = folder / "a.csv";
    const auto line = [&](const char* text) {
        write_text(path, text);
        return input_error([&] { read_table(path); });
    };
    const std::string remedy = "; run the stage that writes it";
    CHECK(line("# c\ntime,x\n1,2\n3\n") == path.string() + ":4: 1 values where there are 2 columns" + remedy);
    CHECK(line("time,x\n1,2,3\n") == path.string() + ":2: 3 values where there are 2 columns" + remedy);
    CHECK(line("time,x\n1,wet\n") == path.string() + ":2: \"wet\" is not a number" + remedy);
    CHECK(line("time,x\n1,\n") == path.string() + ":2: \"\" is not a number" + remedy);
    CHECK(line("# only comments\n") == path.string() + ": there is no line of column names" + remedy);
    std::filesystem::remove(path);
    CHECK(input_error([&] { read_table(path); }) == path.string() + ": the file does not exist" + remedy);
}

TEST_CASE("a table of a newer format version is refused, and one without a version is read") {
    const TemporaryFolder folder;
    const auto path = folder / "a.csv";
    write_text(path, "# format: tidewater-table 2\ntime\n1\n");
    CHECK(input_error([&] { read_table(path); }) ==
          path.string() +
              ": its format version 2 is newer than this program's 1; run the stage that writes it");
    write_text(path, "# format: of another program\ntime\n1\n");
    CHECK(read_table(path).row_count() == 1);
}

TEST_CASE("a missing column is named") {
    const TemporaryFolder folder;
    write_text(folder / "a.csv", "time,x\n1,2\n");
    const Table table = read_table(folder / "a.csv");
    CHECK(require_column(table, "x", folder / "a.csv") == std::vector<double>{2.0});
    CHECK(input_error([&] {
              require_column(table, "kinetic", folder / "a.csv");
          }).find("\"kinetic\" is missing") != std::string::npos);
}
