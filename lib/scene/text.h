// Small pieces of text that messages and printed scenes are made of.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tidewater::scene {

// The shortest text that reads back to the same number, as TOML: "0.01", "16", "1e+16". -0 becomes "0".
std::string number_text(double number);

// "16 m"
std::string metres(double length);

// Rounds a computed number to six digits.
double short_number(double number);

// "[16, 1]"
std::string list_text(std::span<const double> numbers);
std::string list_text(std::span<const std::string> words);
// "[2, [2, 0.5]]": a point of one number as that number.
std::string list_text(std::span<const std::vector<double>> points);

// The text as a TOML basic string, with its quotes.
std::string quoted_text(std::string_view text);

// "a, b or c". `last` is the word before the last item.
std::string enumeration(std::span<const std::string> items, std::string_view last = "or");

// The text without blanks at either end.
std::string trimmed(std::string_view text);

// Number of letters to insert, remove or replace to turn a into b (Levenshtein 1966).
std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate nearest to `word`, by its whole name or by its last part ("depth" of "water.depth"). Empty if
// none is near enough to be what was meant.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

// The name of a key without the number of its section, and that number if there is one: "block.size" and 2
// for "block.2.size".
struct NumberedName {
    std::string name;
    std::optional<std::size_t> number;
};
NumberedName split_number(const std::string& name);

// The file's path in the value of a key, and what stands before and behind it: "NETCDF:" and ":variable".
struct FilePart {
    std::string before, path, after;
};
FilePart file_part(const std::string& value);

}  // namespace tidewater::scene
