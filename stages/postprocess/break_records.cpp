#include "break_records.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

// A column of a table of one row and the number that it holds, in the order of the columns.
template <class Record>
struct Column {
    const char* name;
    double& (*value)(Record&);
};

constexpr std::array first_columns{
    Column<FirstIceberg>{"time", [](FirstIceberg& f) -> double& { return f.calving.time; }},
    Column<FirstIceberg>{"length", [](FirstIceberg& f) -> double& { return f.calving.length; }},
    Column<FirstIceberg>{"length_top", [](FirstIceberg& f) -> double& { return f.calving.length_top; }},
    Column<FirstIceberg>{"length_middle", [](FirstIceberg& f) -> double& { return f.calving.length_middle; }},
    Column<FirstIceberg>{"length_bottom", [](FirstIceberg& f) -> double& { return f.calving.length_bottom; }},
    Column<FirstIceberg>{"height", [](FirstIceberg& f) -> double& { return f.calving.height; }},
    Column<FirstIceberg>{"volume", [](FirstIceberg& f) -> double& { return f.calving.volume; }},
    Column<FirstIceberg>{"plane_angle", [](FirstIceberg& f) -> double& { return f.calving.plane_angle; }},
    Column<FirstIceberg>{"plane_misfit", [](FirstIceberg& f) -> double& { return f.calving.plane_misfit; }},
    Column<FirstIceberg>{"foot_angle", [](FirstIceberg& f) -> double& { return f.calving.foot_angle; }},
    Column<FirstIceberg>{"start_height", [](FirstIceberg& f) -> double& { return f.calving.start_height; }},
    Column<FirstIceberg>{"start_time", [](FirstIceberg& f) -> double& { return f.calving.start_time; }},
    Column<FirstIceberg>{"crack_time", [](FirstIceberg& f) -> double& { return f.crack.time; }},
    Column<FirstIceberg>{"crack_start_height",
                         [](FirstIceberg& f) -> double& { return f.crack.start_height; }},
    Column<FirstIceberg>{"crack_start_time", [](FirstIceberg& f) -> double& { return f.crack.start_time; }},
    Column<FirstIceberg>{"crack_position", [](FirstIceberg& f) -> double& { return f.crack.position; }},
    Column<FirstIceberg>{"failed_share", [](FirstIceberg& f) -> double& { return f.failed_share; }},
    Column<FirstIceberg>{"ice_height", [](FirstIceberg& f) -> double& { return f.ice_height; }},
    Column<FirstIceberg>{"end_time", [](FirstIceberg& f) -> double& { return f.end_time; }},
};

constexpr std::array event_columns{
    Column<MainEvent>{"time", [](MainEvent& e) -> double& { return e.calving.time; }},
    Column<MainEvent>{"time_before", [](MainEvent& e) -> double& { return e.time_before; }},
    Column<MainEvent>{"frame", [](MainEvent& e) -> double& { return e.frame; }},
    Column<MainEvent>{"icebergs", [](MainEvent& e) -> double& { return e.icebergs; }},
    Column<MainEvent>{"largest", [](MainEvent& e) -> double& { return e.largest; }},
    Column<MainEvent>{"volume", [](MainEvent& e) -> double& { return e.calving.volume; }},
    Column<MainEvent>{"failed_width", [](MainEvent& e) -> double& { return e.calving.length; }},
    Column<MainEvent>{"failed_width_top", [](MainEvent& e) -> double& { return e.calving.length_top; }},
    Column<MainEvent>{"failed_width_middle", [](MainEvent& e) -> double& { return e.calving.length_middle; }},
    Column<MainEvent>{"failed_width_bottom", [](MainEvent& e) -> double& { return e.calving.length_bottom; }},
    Column<MainEvent>{"height", [](MainEvent& e) -> double& { return e.calving.height; }},
    Column<MainEvent>{"plane_angle", [](MainEvent& e) -> double& { return e.calving.plane_angle; }},
    Column<MainEvent>{"plane_misfit", [](MainEvent& e) -> double& { return e.calving.plane_misfit; }},
    Column<MainEvent>{"foot_angle", [](MainEvent& e) -> double& { return e.calving.foot_angle; }},
    Column<MainEvent>{"start_height", [](MainEvent& e) -> double& { return e.calving.start_height; }},
    Column<MainEvent>{"start_time", [](MainEvent& e) -> double& { return e.calving.start_time; }},
};

// `more` are columns that follow from the others and are not read back.
template <class Record, std::size_t count>
void write_row(const std::filesystem::path& path, Record record,
               const std::array<Column<Record>, count>& columns,
               const std::vector<std::pair<std::string, double>>& more, const Provenance& provenance) {
    std::vector<std::string> names;
    std::vector<double> values;
    for (const auto& column : columns) {
        names.push_back(column.name);
        values.push_back(column.value(record));
    }
    for (const auto& [name, value] : more) {
        names.push_back(name);
        values.push_back(value);
    }
    io::TableWriter table(path, provenance, names);
    table.append(values);
    table.finish();
}

template <class Record, std::size_t count>
std::optional<Record> read_row(const std::filesystem::path& path,
                               const std::array<Column<Record>, count>& columns) {
    if (!std::filesystem::exists(path)) return {};
    const io::Table table = io::read_table(path);
    Record record;
    for (const auto& column : columns) {
        const auto& values = io::require_column(table, column.name, path);
        if (!values.empty()) column.value(record) = values.front();
    }
    return record;
}

std::string percent(double share) { return io::format_fixed(100.0 * share, 1) + " %"; }

std::string place_text(double length) {
    return std::isnan(length) ? "nowhere" : io::format_fixed(length, 1) + " m";
}

// "at the top", "from the bottom", "inside", "from inside".
std::string start_text(analysis::CrackStart start, const std::string& preposition) {
    if (start == analysis::CrackStart::inside) return preposition == "from" ? "from inside" : "inside";
    return preposition + (start == analysis::CrackStart::top ? " the top" : " the bottom");
}

std::string crack_text(const analysis::FirstCrack& crack, double height) {
    if (std::isnan(crack.time)) return "no crack formed\n";
    return "first crack: " + start_text(crack.start(), "from") + ", " + io::format_fixed(crack.position, 0) +
           " m (" + io::format_fixed(crack.position / height, 2) + " H) behind the front, at " +
           io::format_fixed(crack.start_time, 1) + " s\n";
}

std::string calving_text(const analysis::Calving& calving, int dimension) {
    std::string text = "first iceberg: came off at " + io::format_fixed(calving.time, 2) + " s, " +
                       volume_text(calving.volume, dimension);
    if (std::isnan(calving.length)) return text + ", from above or below the rest\n";
    return text + ", " + io::format_fixed(calving.length, 1) + " m long, " +
           io::format_fixed(calving.length / calving.height, 3) + " of its height of " +
           io::format_fixed(calving.height, 1) + " m\nits crack: began " + start_text(calving.start(), "at") +
           " at " + io::format_fixed(calving.start_time, 2) + " s; behind the front by " +
           place_text(calving.length_top) + " at the top, " + place_text(calving.length_middle) +
           " halfway, " + place_text(calving.length_bottom) + " at the bottom\n";
}

}  // namespace

void write_first_iceberg(const std::filesystem::path& folder, const FirstIceberg& first, double density,
                         const Provenance& provenance) {
    const analysis::Calving& c = first.calving;
    write_row(folder / first_iceberg_file, first, first_columns,
              {{"length_ratio", c.length / c.height}, {"mass", density * c.volume}}, provenance);
}

void write_main_event(const std::filesystem::path& folder, const MainEvent& event, double density,
                      const Provenance& provenance) {
    write_row(folder / main_event_file, event, event_columns, {{"mass", density * event.calving.volume}},
              provenance);
}

std::optional<FirstIceberg> read_first_iceberg(const std::filesystem::path& folder) {
    return read_row(folder / first_iceberg_file, first_columns);
}

std::optional<MainEvent> read_main_event(const std::filesystem::path& folder) {
    return read_row(folder / main_event_file, event_columns);
}

std::string volume_text(double volume, int dimension) {
    return io::format_fixed(volume, 0) + (dimension == 2 ? " m² per m of width" : " m³");
}

std::string describe(const FirstIceberg& first, int dimension) {
    const std::string crack = crack_text(first.crack, first.ice_height);
    if (!std::isnan(first.calving.time)) return crack + calving_text(first.calving, dimension);
    return crack + "no iceberg came off: " + percent(first.failed_share) + " of the ice failed\n";
}

std::string describe(const MainEvent& event, int dimension) {
    if (std::isnan(event.frame)) return "main event: none, nothing came off the glacier\n";
    const analysis::Calving& c = event.calving;
    const auto number = [](double value, int decimals) {
        return std::isnan(value) ? std::string("unknown") : io::format_fixed(value, decimals);
    };
    return "main event: between " + number(event.time_before, 2) + " and " + number(c.time, 2) + " s, " +
           volume_text(c.volume, dimension) + " in " + number(event.icebergs, 0) +
           (event.icebergs == 1.0 ? " iceberg" : " icebergs") + "; failed width " + place_text(c.length) +
           ", at the top " + place_text(c.length_top) + "; failure plane " + number(c.plane_angle, 0) +
           "° by fit, " + number(c.foot_angle, 0) + "° from the front's foot\n";
}

}  // namespace tidewater::postprocess
