// A TOML text as a flat list of settings, each with the line it stands on. The only user of toml++.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tidewater::scene {

// What no key takes, described for a message: "true", "a date", "abc, which is not a TOML value".
struct Foreign {
    std::string description;
};

// Points in space; one of a single number stands in its list as that number.
using Points = std::vector<std::vector<double>>;

// An empty list, and one of numbers alone, is a std::vector<double>.
using Value = std::variant<std::int64_t, bool, double, std::string, std::vector<double>, Points,
                           std::vector<std::string>, Foreign>;

// The value for a message: `text "abc"`, `2.5`, `a list of 3 numbers`.
std::string describe(const Value& value);

struct Entry {
    std::string key;  // with its sections: "domain.cell_size"; in the second of [[block]] "block.2.angle"
    Value value;
    int line = 0;  // from 1
};

struct SyntaxProblem {
    int line = 0;
    std::string text;
};

struct Document {
    std::vector<Entry> entries;  // in the order of the text; empty if a problem kept the text from being read
    std::map<std::string, std::size_t> sections;  // how often each [[name]] stands there
    std::vector<SyntaxProblem> problems;
    bool readable = true;
};

// Reads on after a duplicate key (reported, the first one counts) and after a value without quotes (kept as
// Foreign), so that the scene's other problems can be told at once. After any other error the document is not
// readable. The sections in `repeatable` may stand under double brackets, and the message of a duplicate one
// says so.
Document parse_toml(std::string_view text, std::span<const std::string> repeatable = {});

// The value of a --set option. What is not a TOML value is taken as text.
Value parse_value(const std::string& text);

}  // namespace tidewater::scene
