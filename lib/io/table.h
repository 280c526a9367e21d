// Tables of numbers as CSV: the line "# format: tidewater-table 1", lines "# key: value" with the provenance,
// one line of column names, then one line per row. Numbers are written so that they read back to the same
// value; "nan" means that there is none.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files.h"
#include "core/provenance.h"

namespace tidewater::io {

inline constexpr int table_format_version = 1;

// A file that grows row by row while a stage works, under <path>.part; finish() gives it its name. If
// finish() is not reached, nothing is left. All members throw OutputError if the file cannot be written.
//     TableWriter gauges(run / "gauges.csv", provenance, {"time", "x=2"});
//     gauges.append(std::array{0.0, 0.01});
//     gauges.finish();
class TableWriter {
public:
    // Column names must not hold commas, quotes or line ends.
    TableWriter(const std::filesystem::path& path, const Provenance& provenance,
                std::vector<std::string> columns);

    // One value per column. The row is handed to the system at once, so that the file can be followed.
    void append(std::span<const double> row);

    // For tables with words among the numbers; cells are written as they are.
    void append_cells(std::span<const std::string> row);

    // The file so far.
    std::string text();
    // Replaces the file so far by a text() that an earlier process got, to go on behind it.
    void resume(const std::string& text);

    void finish();
    // Leaves what there is under <path>.part.
    void keep_part() { part_.keep(); }

private:
    void require_written() const;

    std::filesystem::path path_;
    PartFile part_;
    std::ofstream stream_;
    std::size_t column_count_;
};

struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> values;  // values[c][r]: column c, row r

    std::size_t row_count() const { return values.empty() ? 0 : values.front().size(); }

    // nullptr if there is no such column.
    const std::vector<double>* find(std::string_view column) const;
};

// Reads a table of numbers. Of a file that still grows, whose name ends with .part, a last line without an
// end does not count yet. Throws InputError if the file is missing, of a newer format version or has no line
// of column names, or with "file:line" if a row has too few or too many values or one that is not a number.
Table read_table(const std::filesystem::path& path);

// The column of a table that was read from `path`. Throws InputError if there is none.
const std::vector<double>& require_column(const Table& table, std::string_view column,
                                          const std::filesystem::path& path);

}  // namespace tidewater::io
