#include "scene/toml_document.h"

#include <toml++/toml.h>
#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "scene/text.h"

namespace tidewater::scene {
namespace {

// Nothing if an item is not a number.
std::optional<std::vector<double>> numbers_of(const toml::array& array) {
    std::vector<double> numbers;
    for (const toml::node& item : array) {
        if (!item.is_number()) return std::nullopt;
        numbers.push_back(*item.value<double>());
    }
    return numbers;
}

// A list of lists of numbers, or of numbers and such lists; nothing if it is neither.
std::optional<Points> points_of(const toml::array& array) {
    Points points;
    for (const toml::node& item : array) {
        const auto* list = item.as_array();
        std::optional<std::vector<double>> point;
        if (list != nullptr) point = numbers_of(*list);
        if (item.is_number()) point = {*item.value<double>()};
        if (!point) return std::nullopt;
        points.push_back(*point);
    }
    return points;
}

Value list_value(const toml::array& array) {
    const auto is_list = [](const toml::node& item) { return item.is_array(); };
    if (std::ranges::any_of(array, is_list)) {
        if (auto points = points_of(array)) return *points;
    }
    std::vector<double> numbers;
    std::vector<std::string> words;
    for (const toml::node& item : array) {
        if (item.is_number()) {
            numbers.push_back(*item.value<double>());
        } else if (item.is_string()) {
            words.push_back(*item.value<std::string>());
        } else {
            return Foreign{item.is_table() ? "a list of sections" : "a list of other things"};
        }
    }
    if (!numbers.empty() && !words.empty()) return Foreign{"a list of numbers and words"};
    if (!words.empty()) return words;
    return numbers;
}

Value node_value(const toml::node& node) {
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* array = node.as_array()) return list_value(*array);
    if (const auto* truth = node.as_boolean()) return truth->get();
    return Foreign{"a date or time"};
}

void flatten(const toml::table& table, const std::string& section, Document& document) {
    for (const auto& [name, node] : table) {
        const std::string key = section + std::string(name.str());
        if (const auto* inner = node.as_table()) {
            flatten(*inner, key + ".", document);
        } else if (node.is_array_of_tables()) {
            std::size_t& count = document.sections[key];
            for (const toml::node& item : *node.as_array())
                flatten(*item.as_table(), key + "." + std::to_string(++count) + ".", document);
        } else {
            document.entries.push_back({key, node_value(node), static_cast<int>(name.source().begin.line)});
        }
    }
}

// The lines of a text, and what had to be taken out of them to read the rest.
struct Repair {
    std::vector<std::string> lines;
    std::map<int, std::string> unquoted;  // by line
    std::vector<SyntaxProblem> problems;

    std::string& line(int number) { return lines[static_cast<std::size_t>(number - 1)]; }
    std::string text() const;
    std::string section_above(int number) const;
};

std::string Repair::text() const {
    std::string joined;
    for (const std::string& one : lines) joined += one + "\n";
    return joined;
}

// "water." for a line below [water] or [[water]].
std::string Repair::section_above(int number) const {
    for (int i = number - 1; i > 0; --i) {
        const std::string above = trimmed(lines[static_cast<std::size_t>(i - 1)]);
        const auto name = above.find_first_not_of('[');
        if (name != 0 && name != above.npos) return trimmed(above.substr(name, above.find(']') - name)) + ".";
    }
    return {};
}

// Takes the cause of the error out of its line. False if that could hide what the other lines mean.
bool repair(const toml::parse_error& error, Repair& repair) {
    const int number = static_cast<int>(error.source().begin.line);
    if (number < 1 || number > static_cast<int>(repair.lines.size())) return false;
    std::string& line = repair.line(number);
    const auto equals = line.find('=');
    if (equals == std::string::npos || line.starts_with('[')) return false;
    const std::string key = trimmed(line.substr(0, equals));
    const std::string_view why = error.description();
    if (why.find("could not determine value type") != why.npos && !repair.unquoted.contains(number)) {
        const std::string value = line.substr(equals + 1);
        repair.unquoted[number] = trimmed(value.substr(0, value.find('#')));
        line = key + " = false";
        return true;
    }
    if (why.find("cannot redefine") == why.npos) return false;
    repair.problems.push_back(
        {number, repair.section_above(number) + key + ": duplicate key; keep one of them"});
    line.clear();
    return true;
}

std::string plain_reason(const toml::parse_error& error, std::span<const std::string> repeatable) {
    const std::string why(error.description());
    const auto table = why.find("cannot redefine existing table ");
    if (table == why.npos) return "not TOML: " + why;
    const std::string name = why.substr(why.find('\''));
    for (const std::string& section : repeatable) {
        if (name == "'" + section + "'")
            return "duplicate section " + name + "; if there are several, write [[" + section +
                   "]] above each";
    }
    return "duplicate section " + name + "; move its keys to the first one";
}

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream stream{std::string(text)};
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

std::string describe(const Value& value) {
    struct Describe {
        std::string operator()(std::int64_t whole) const { return std::to_string(whole); }
        std::string operator()(bool truth) const { return truth ? "true" : "false"; }
        std::string operator()(double number) const { return number_text(number); }
        std::string operator()(const std::string& text) const { return "text " + quoted_text(text); }
        std::string operator()(const std::vector<double>& list) const { return count(list.size(), "number"); }
        std::string operator()(const Points& list) const { return count(list.size(), "point"); }
        std::string operator()(const std::vector<std::string>& list) const {
            return count(list.size(), "word");
        }
        std::string operator()(const Foreign& foreign) const { return foreign.description; }
        static std::string count(std::size_t size, const char* what) {
            if (size == 0) return "an empty list";
            return "a list of " + std::to_string(size) + " " + what + (size == 1 ? "" : "s");
        }
    };
    return std::visit(Describe{}, value);
}

Document parse_toml(std::string_view text, std::span<const std::string> repeatable) {
    Repair repaired{.lines = split_lines(text), .unquoted = {}, .problems = {}};
    Document document;
    while (true) {
        try {
            flatten(toml::parse(repaired.text()), "", document);
            break;
        } catch (const toml::parse_error& error) {
            if (repair(error, repaired)) continue;
            repaired.problems.push_back(
                {static_cast<int>(error.source().begin.line), plain_reason(error, repeatable)});
            document.readable = false;
            break;
        }
    }
    for (Entry& entry : document.entries) {
        const auto found = repaired.unquoted.find(entry.line);
        if (found != repaired.unquoted.end()) {
            entry.value = Foreign{found->second + ", which is not a TOML value (text needs quotes)"};
        }
    }
    std::ranges::stable_sort(document.entries, {}, &Entry::line);
    document.problems = std::move(repaired.problems);
    return document;
}

Value parse_value(const std::string& text) {
    try {
        const toml::table table = toml::parse("value = " + text);
        const toml::node* node = table.get("value");
        if (node != nullptr && table.size() == 1 && !node->is_table()) return node_value(*node);
    } catch (const toml::parse_error&) {
    }
    return text;
}

}  // namespace tidewater::scene
