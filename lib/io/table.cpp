#include "io/table.h"

#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/error.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr std::string_view format_prefix = "# format: tidewater-table ";
constexpr const char* remedy = "; run the stage that writes it";

std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> cells;
    while (true) {
        const auto comma = line.find(',');
        cells.push_back(line.substr(0, comma));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

std::string join(std::span<const std::string> cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + cells[i];
    return line;
}

void append_row(Table& table, std::string_view line, const std::string& place) {
    const auto cells = split(line);
    if (cells.size() != table.columns.size()) {
        throw InputError(place + ": " + std::to_string(cells.size()) + " values where there are " +
                         std::to_string(table.columns.size()) + " columns" + remedy);
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const auto value = parse_number(cells[c]);
        if (!value) throw InputError(place + ": \"" + std::string(cells[c]) + "\" is not a number" + remedy);
        table.values[c].push_back(*value);
    }
}

// A first line without the format is accepted: tables of other programs, and older ones.
void check_format(std::string_view first_line, const std::filesystem::path& path) {
    if (!first_line.starts_with(format_prefix)) return;
    const std::string version(first_line.substr(format_prefix.size()));
    const auto number = parse_number(version);
    if (!number || *number > table_format_version) {
        throw InputError(path.string() + ": its format version " + version +
                         " is newer than this program's " + std::to_string(table_format_version) + remedy);
    }
}

}  // namespace

TableWriter::TableWriter(const std::filesystem::path& path, const Provenance& provenance,
                         std::vector<std::string> columns)
    : path_(path), part_(path), stream_(part_.part_path(), std::ios::binary), column_count_(columns.size()) {
    stream_ << format_prefix << table_format_version << '\n';
    for (const auto& [name, text] : provenance_fields(provenance))
        stream_ << "# " << name << ": " << text << '\n';
    append_cells(columns);
}

void TableWriter::append(std::span<const double> row) {
    std::vector<std::string> cells;
    for (const double value : row) cells.push_back(format_number(value));
    append_cells(cells);
}

void TableWriter::append_cells(std::span<const std::string> row) {
    if (row.size() != column_count_)
        throw std::invalid_argument("TableWriter: a row needs one value per column");
    stream_ << join(row) << '\n' << std::flush;
    require_written();
}

std::string TableWriter::text() {
    stream_.flush();
    require_written();
    return read_text(part_.part_path());
}

void TableWriter::resume(const std::string& text) {
    stream_.close();
    stream_.open(part_.part_path(), std::ios::binary | std::ios::trunc);
    stream_ << text << std::flush;
    require_written();
}

void TableWriter::require_written() const {
    if (!stream_) throw OutputError(path_.string() + ": writing failed; free disk space and run again");
}

void TableWriter::finish() {
    stream_.close();
    require_written();
    part_.commit();
}

const std::vector<double>* Table::find(std::string_view column) const {
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (columns[c] == column) return &values[c];
    }
    return nullptr;
}

Table read_table(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path))
        throw InputError(path.string() + ": the file does not exist" + remedy);
    std::string all = read_text(path);
    if (path.extension() == ".part") all.resize(all.rfind('\n') + 1);  // of npos: 0
    std::istringstream text(all);
    Table table;
    std::string line;
    for (std::size_t number = 1; std::getline(text, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (number == 1) check_format(line, path);
        if (line.empty() || line.front() == '#') continue;
        if (table.columns.empty()) {
            for (const auto name : split(line)) table.columns.emplace_back(name);
            table.values.resize(table.columns.size());
        } else {
            append_row(table, line, path.string() + ":" + std::to_string(number));
        }
    }
    if (table.columns.empty())
        throw InputError(path.string() + ": there is no line of column names" + remedy);
    return table;
}

const std::vector<double>& require_column(const Table& table, std::string_view column,
                                          const std::filesystem::path& path) {
    const auto* values = table.find(column);
    if (!values) {
        throw InputError(path.string() + ": column \"" + std::string(column) + "\" is missing" + remedy);
    }
    return *values;
}

}  // namespace tidewater::io
