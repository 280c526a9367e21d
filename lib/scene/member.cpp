#include "scene/member.h"

namespace tidewater::scene {
namespace {

template <class T>
bool convert_same(const Value& value, T& to) {
    const auto* same = std::get_if<T>(&value);
    if (same != nullptr) to = *same;
    return same != nullptr;
}

}  // namespace

bool convert(const Value& value, bool& to) { return convert_same(value, to); }
bool convert(const Value& value, std::string& to) { return convert_same(value, to); }
bool convert(const Value& value, std::vector<double>& to) { return convert_same(value, to); }

bool convert(const Value& value, double& to) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) to = static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value)) to = *number;
    return std::holds_alternative<std::int64_t>(value) || std::holds_alternative<double>(value);
}

bool convert(const Value& value, std::uint64_t& to) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    if (whole == nullptr || *whole < 0) return false;
    to = static_cast<std::uint64_t>(*whole);
    return true;
}

bool convert(const Value& value, int& to) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    if (whole == nullptr) return false;
    to = static_cast<int>(std::clamp<std::int64_t>(*whole, -1'000'000'000, 1'000'000'000));
    return true;
}

// A list of numbers alone is a list of points with one coordinate each.
bool convert(const Value& value, Points& to) {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (numbers == nullptr) return convert_same(value, to);
    to.clear();
    for (const double number : *numbers) to.push_back({number});
    return true;
}

// An empty list has no type of its own in TOML.
bool convert(const Value& value, std::vector<std::string>& to) {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (numbers == nullptr || !numbers->empty()) return convert_same(value, to);
    to.clear();
    return true;
}

}  // namespace tidewater::scene
