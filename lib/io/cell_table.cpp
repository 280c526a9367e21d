#include "io/cell_table.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "core/error.h"
#include "core/files.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char letter : line) {
        if (letter == ',') {
            cells.emplace_back();
        } else if (letter != '\r') {
            cells.back() += letter;
        }
    }
    return cells;
}

}  // namespace

std::size_t CellTable::index(std::string_view column) const {
    return static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin());
}

std::string CellTable::word(std::size_t row, std::string_view column) const {
    const std::size_t c = index(column);
    return row < rows.size() && c < columns.size() ? rows[row][c] : std::string();
}

double CellTable::number(std::size_t row, std::string_view column) const {
    return parse_number(word(row, column)).value_or(std::numeric_limits<double>::quiet_NaN());
}

CellTable read_cells(const std::filesystem::path& path) {
    std::istringstream text(read_text(path));
    CellTable table;
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        if (line.starts_with('#')) continue;
        std::vector<std::string> cells = split(line);
        if (table.columns.empty()) {
            table.columns = std::move(cells);
        } else if (cells.size() == table.columns.size()) {
            table.rows.push_back(std::move(cells));
        } else {
            throw InputError(path.string() + ":" + std::to_string(number) + ": " +
                             std::to_string(cells.size()) + " values instead of " +
                             std::to_string(table.columns.size()) + "; make the table again");
        }
    }
    if (table.columns.empty()) throw InputError(path.string() + ": no line of column names");
    return table;
}

}  // namespace tidewater::io
