#include "quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/error.h"
#include "io/cell_table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

enum class Row { first, last, greatest };

struct Source {
    const char* name;
    const char* label;
    const char* unit;
    const char* file;
    const char* column;
    Row row = Row::first;
};

constexpr std::array catalogue{
    Source{"celerity", "celerity of the leading crest over the gauges", "m/s", "waves.csv", "celerity",
           Row::last},
    Source{"crest", "highest leading crest at a gauge", "m", "waves.csv", "crest", Row::greatest},
    Source{"elevation", "highest water at a gauge", "m", "waves.csv", "greatest", Row::greatest},
    Source{"significant_height", "greatest significant wave height", "m", "waves.csv", "H_s", Row::greatest},
    Source{"peak_period", "longest peak period", "s", "waves.csv", "T_p", Row::greatest},
    Source{"block_speed", "greatest speed of the block's fastest point", "m/s", "tsunami.csv", "speed"},
    Source{"wave_amplitude", "first wave's greatest amplitude", "m", "tsunami.csv", "amplitude"},
    Source{"wave_celerity", "first wave's celerity", "m/s", "tsunami.csv", "celerity"},
    Source{"decay_exponent", "decay of the wave with distance, exponent", "", "decay_fit.csv", "exponent"},
    Source{"run_up", "highest run-up on the far shore", "m", "run_up.csv", "height", Row::greatest},
    Source{"detachment_time", "first iceberg comes off at", "s", "first_iceberg.csv", "time"},
    Source{"iceberg_length", "first iceberg's length", "m", "first_iceberg.csv", "length"},
    Source{"iceberg_length_ratio", "first iceberg's length over its height, Li/Hi", "", "first_iceberg.csv",
           "length_ratio"},
    Source{"iceberg_volume", "first iceberg's volume", volume_unit, "first_iceberg.csv", "volume"},
    Source{"failed_width", "failed width of the main event", "m", "main_event.csv", "failed_width"},
    Source{"failure_angle", "angle of the failure plane", "°", "main_event.csv", "plane_angle"},
    Source{"calved_volume", "calved volume", volume_unit, "calving.csv", "calved_total", Row::last},
};

bool is_there(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
}

double value_of(const io::CellTable& table, const Source& source) {
    if (table.rows.empty()) return nothing;
    if (source.row == Row::first) return table.number(0, source.column);
    if (source.row == Row::last) return table.number(table.rows.size() - 1, source.column);
    double greatest = nothing;
    for (std::size_t r = 0; r < table.rows.size(); ++r)
        greatest = std::fmax(greatest, table.number(r, source.column));
    return greatest;
}

// Of the row whose x is nearest.
double value_at(const io::CellTable& table, const Source& source, double x) {
    double nearest = std::numeric_limits<double>::infinity(), value = nothing;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const double distance = std::abs(table.number(r, "x") - x);
        if (!(distance < nearest)) continue;
        nearest = distance;
        value = table.number(r, source.column);
    }
    return value;
}

Quantity quantity(const std::filesystem::path& folder, const Source& source) {
    const auto path = folder / source.file;
    const double value = is_there(path) ? value_of(io::read_cells(path), source) : nothing;
    return {source.name, source.label, source.unit, value};
}

const Source* source_named(const std::string& name) {
    const auto found = std::ranges::find(catalogue, name, &Source::name);
    return found == catalogue.end() ? nullptr : &*found;
}

// "crest@250" is crest and 250.
std::pair<std::string, double> split_place(const std::string& name) {
    const auto at = name.find('@');
    if (at == name.npos) return {name, nothing};
    return {name.substr(0, at), io::parse_number(name.substr(at + 1)).value_or(nothing)};
}

[[noreturn]] void refuse(const std::string& text, const std::string& problem) {
    throw SceneError("postprocess.references: \"" + text + "\": " + problem);
}

double bound(const std::string& text, const std::string& word, double open) {
    if (word == "-") return open;
    const auto number = io::parse_number(word);
    if (!number || std::isnan(*number))
        refuse(text, "\"" + word + "\" is not a number; - stands for no bound");
    return *number;
}

void require_known(const std::string& text, const std::string& name) {
    const auto [plain, place] = split_place(name);
    const Source* source = source_named(plain);
    if (!source) {
        std::string known;
        for (const Source& each : catalogue) known += (known.empty() ? "" : ", ") + std::string(each.name);
        refuse(text, "unknown quantity " + name + "; one of " + known);
    }
    const bool has_place = name.find('@') != name.npos;
    if (has_place && (std::isnan(place) || std::string(source->file) != "waves.csv"))
        refuse(text, "no place of a gauge; crest@250 is the crest at x = 250 m");
}

}  // namespace

std::vector<Quantity> told_quantities(const std::filesystem::path& folder) {
    std::vector<Quantity> told;
    for (const Source& source : catalogue) {
        told.push_back(quantity(folder, source));
        if (std::isnan(told.back().value)) told.pop_back();
    }
    return told;
}

Quantity find_quantity(const std::filesystem::path& folder, const std::string& name) {
    const auto [plain, x] = split_place(name);
    const Source* source = source_named(plain);
    if (!source) return {name, name, "", nothing};
    if (std::isnan(x)) return quantity(folder, *source);
    const auto path = folder / source->file;
    const double value = is_there(path) ? value_at(io::read_cells(path), *source, x) : nothing;
    const std::string column = source->column;
    const std::string what = column == "crest"      ? "leading crest"
                             : column == "greatest" ? "highest water"
                                                    : column;
    return {name, what + " at x = " + io::format_number(x) + " m", source->unit, value};
}

std::vector<Reference> parse_references(const std::vector<std::string>& texts) {
    std::vector<Reference> references;
    for (const std::string& text : texts) {
        std::istringstream words(text);
        std::string name, low, high, source;
        words >> name >> low >> high;
        std::getline(words >> std::ws, source);
        if (source.empty())
            refuse(text, "needs name, least, greatest and source, as \"celerity 31 38 theory\"");
        require_known(text, name);
        constexpr double open = std::numeric_limits<double>::infinity();
        references.push_back({name, bound(text, low, -open), bound(text, high, open), source});
        if (references.back().low > references.back().high) refuse(text, "the least is above the greatest");
    }
    return references;
}

}  // namespace tidewater::postprocess
