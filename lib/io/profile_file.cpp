#include "io/profile_file.h"

#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/files.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

// The cells of a line: between commas or semicolons, if it has any, else between blanks.
std::vector<std::string_view> cells_of(std::string_view line) {
    const bool marks = line.find_first_of(",;") != std::string_view::npos;
    const std::string_view separators = marks ? ",;" : blanks;
    std::vector<std::string_view> cells;
    while (true) {
        const auto end = line.find_first_of(separators);
        cells.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) return cells;
        line = marks ? line.substr(end + 1) : trimmed(line.substr(end));
    }
}

bool is_header(const std::vector<std::string_view>& cells) {
    for (const auto cell : cells) {
        if (cell.empty() || parse_number(cell)) return false;
    }
    return true;
}

double number(std::string_view cell, const std::string& place) {
    const auto value = parse_number(cell);
    if (value && std::isfinite(*value)) return *value;
    throw InputError(place + ": \"" + std::string(cell) +
                     "\" is not a number; each line needs x and z in m, as " + "\"120.5, -35\"");
}

}  // namespace

ProfileTable read_profile(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path))
        throw InputError(path.string() + ": the file does not exist; check the path");
    std::istringstream text(read_text(path));
    ProfileTable table;
    std::string line;
    bool first = true;
    for (std::size_t count = 1; std::getline(text, line); ++count) {
        const std::string_view content = trimmed(std::string_view(line).substr(0, line.find('#')));
        if (content.empty()) continue;
        const auto cells = cells_of(content);
        const bool names = first && is_header(cells);
        first = false;
        if (names) continue;
        const std::string place = path.string() + ":" + std::to_string(count);
        if (cells.size() != 2) {
            throw InputError(place + ": " + std::to_string(cells.size()) +
                             " values where a profile has two, x and z in m, as \"120.5, -35\"");
        }
        const double x = number(cells[0], place), z = number(cells[1], place);
        if (!table.x.empty() && x <= table.x.back()) {
            throw InputError(place + ": x = " + format_number(x) + " m does not rise over the " +
                             format_number(table.x.back()) +
                             " m before; sort the points by x, one for each x");
        }
        table.x.push_back(x);
        table.z.push_back(z);
    }
    if (table.x.size() < 2) {
        throw InputError(path.string() + ": a profile needs two points or more, and here are " +
                         std::to_string(table.x.size()) + "; give each a line \"x, z\" in m");
    }
    return table;
}

}  // namespace tidewater::io
