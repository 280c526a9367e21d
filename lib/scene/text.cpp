#include "scene/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace tidewater::scene {
namespace {

std::string bracketed(const std::vector<std::string>& items) {
    std::string text = "[";
    for (std::size_t i = 0; i < items.size(); ++i) text += (i == 0 ? "" : ", ") + items[i];
    return text + "]";
}

std::string_view last_part(std::string_view key) { return key.substr(key.rfind('.') + 1); }

}  // namespace

std::string number_text(double number) {
    char text[64];
    // Not fixed for large numbers: TOML takes digits alone as an integer, which may not hold them.
    const double size = std::abs(number);
    const bool fixed = size == 0.0 || (size >= 1e-4 && size < 1e12);
    const auto format = fixed ? std::chars_format::fixed : std::chars_format::scientific;
    const auto end = std::to_chars(text, text + sizeof text, number + 0.0, format).ptr;
    return {text, end};
}

std::string metres(double length) { return number_text(length) + " m"; }

double short_number(double number) {
    if (number == 0.0 || !std::isfinite(number)) return number;
    const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(number))));
    return std::round(number * scale) / scale;
}

std::string list_text(std::span<const double> numbers) {
    std::vector<std::string> items;
    for (const double number : numbers) items.push_back(number_text(number));
    return bracketed(items);
}

std::string list_text(std::span<const std::string> words) {
    std::vector<std::string> items;
    for (const std::string& word : words) items.push_back(quoted_text(word));
    return bracketed(items);
}

std::string list_text(std::span<const std::vector<double>> points) {
    std::vector<std::string> items;
    for (const auto& point : points)
        items.push_back(point.size() == 1 ? number_text(point.front()) : list_text(std::span(point)));
    return bracketed(items);
}

std::string quoted_text(std::string_view text) {
    std::string result = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') {
            result += '\\';
            result += letter;
        } else if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(letter));
            result += escape;
        } else {
            result += letter;
        }
    }
    return result + "\"";
}

std::string enumeration(std::span<const std::string> items, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) text += i + 1 == items.size() ? " " + std::string(last) + " " : ", ";
        text += items[i];
    }
    return text;
}

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == text.npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row[b.size()];
}

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
    const std::size_t far = std::max<std::size_t>(2, last_part(word).size() / 3) + 1;
    std::size_t best = far;
    std::string found;
    for (const std::string& candidate : candidates) {
        const std::size_t whole = edit_distance(word, candidate);
        const std::size_t part = edit_distance(last_part(word), last_part(candidate)) + 2;
        if (std::min(whole, part) >= best) continue;
        best = std::min(whole, part);
        found = candidate;
    }
    return found;
}

NumberedName split_number(const std::string& name) {
    const auto first = name.find('.'), second = name.rfind('.');
    if (first == second) return {name, {}};
    std::size_t number = 0;
    const char *from = name.data() + first + 1, *to = name.data() + second;
    const auto [end, error] = std::from_chars(from, to, number);
    if (error != std::errc() || end != to) return {name, {}};
    return {name.substr(0, first) + name.substr(second), number};
}

FilePart file_part(const std::string& value) {
    const std::string netcdf = "NETCDF:";
    if (!value.starts_with(netcdf)) return {{}, value, {}};
    const std::string rest = value.substr(netcdf.size());
    const auto colon = rest.rfind(':');
    if (colon == rest.npos) return {netcdf, rest, {}};
    return {netcdf, rest.substr(0, colon), rest.substr(colon)};
}

}  // namespace tidewater::scene
