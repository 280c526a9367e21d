// Any table of table.h's form as text, words among the numbers too: for showing tables and for picking single
// values out of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tidewater::io {

struct CellTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  // of as many cells as there are columns

    // The column's index; columns.size() if there is none.
    std::size_t index(std::string_view column) const;
    // The cell as a number; NaN if there is no such column or row, or the cell holds a word.
    double number(std::size_t row, std::string_view column) const;
    // Empty if there is no such column or row.
    std::string word(std::size_t row, std::string_view column) const;
};

// Throws InputError if the file cannot be read or has no line of column names, or with "file:line" if a row
// has too few or too many cells.
CellTable read_cells(const std::filesystem::path& path);

}  // namespace tidewater::io
