#include "io/column_map.h"

#include <array>
#include <cmath>

#include "core/error.h"
#include "io/snapshot.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const auto end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

struct Entry {
    std::string_view name, value;
};

// "name=value,name=value"; `example` tells how an entry should look.
std::vector<Entry> parse_entries(std::string_view text, const std::string& option,
                                 const std::string& example) {
    std::vector<Entry> entries;
    for (const std::string_view entry : split(text, ',')) {
        const auto equals = entry.find('=');
        if (equals == 0 || equals == std::string_view::npos || equals + 1 == entry.size())
            throw SceneError(option + ": \"" + std::string(entry) + "\" is no entry like " + example);
        entries.push_back({entry.substr(0, equals), entry.substr(equals + 1)});
    }
    return entries;
}

// The components of a column; 0 if there is none of that name.
int components_of(std::string_view name) {
    int components = 0;
    for_each_column([&](const auto& column) {
        if (column.name == name) components = column.components;
    });
    return components;
}

std::string column_names() {
    std::string names;
    for_each_column(
        [&](const auto& column) { names += (names.empty() ? "" : ", ") + std::string(column.name); });
    return names;
}

// "state[2]" or "state".
ArrayPart parse_part(std::string_view text, std::string_view column) {
    const auto bracket = text.find('[');
    if (bracket == std::string_view::npos && !text.empty()) return {.array = std::string(text)};
    std::optional<double> component;
    if (bracket != std::string_view::npos && bracket > 0 && text.back() == ']')
        component = parse_number(text.substr(bracket + 1, text.size() - bracket - 2));
    if (!component || *component < 0.0 || *component > 99.0 || *component != std::floor(*component)) {
        throw SceneError("--map: \"" + std::string(text) + "\" for " + std::string(column) +
                         " is no array or component like state[2]");
    }
    return {.array = std::string(text.substr(0, bracket)), .component = static_cast<int>(*component)};
}

}  // namespace

std::optional<Material> material_named(std::string_view name) {
    for (const Material material : all_materials) {
        if (material_name(material) == name) return material;
    }
    return {};
}

ColumnSource column_source(const ColumnMap& map, std::string_view column) {
    const auto found = map.find(column);
    return found == map.end() ? ColumnSource{{.array = std::string(column)}} : found->second;
}

ColumnMap parse_column_map(std::string_view text) {
    ColumnMap map;
    for (const auto& [name, value] : parse_entries(text, "--map", "velocity=vel")) {
        const int components = components_of(name);
        if (components == 0) {
            throw SceneError("--map: \"" + std::string(name) + "\" is no column; the columns are " +
                             column_names());
        }
        ColumnSource source;
        for (const std::string_view part : split(value, ':')) source.push_back(parse_part(part, name));
        if (source.size() > static_cast<std::size_t>(components) && source.size() > 1) {
            throw SceneError("--map: " + std::string(name) + " has " + std::to_string(components) +
                             " components, not " + std::to_string(source.size()));
        }
        if (!map.emplace(name, std::move(source)).second)
            throw SceneError("--map: " + std::string(name) + " is named twice");
    }
    return map;
}

MaterialNumbers parse_material_numbers(std::string_view text) {
    MaterialNumbers numbers;
    for (const auto& [name, value] : parse_entries(text, "--materials", "water=3")) {
        const auto number = parse_number(value);
        const auto material = material_named(name);
        if (!material || !number || *number != std::floor(*number) || std::abs(*number) > 1e9) {
            throw SceneError("--materials: \"" + std::string(name) + "=" + std::string(value) +
                             "\" is not water, ice or rigid with a whole number, like water=3");
        }
        if (!numbers.emplace(static_cast<int>(*number), *material).second)
            throw SceneError("--materials: " + std::string(value) + " is named twice");
    }
    return numbers;
}

}  // namespace tidewater::io
