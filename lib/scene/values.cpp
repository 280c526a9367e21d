// How a key's value is read from TOML, checked against its type and range, and printed.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/keys.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

// The names of an enum's values, in the order of their numbers.
template <class Enum>
constexpr bool enum_names = false;
template <>
constexpr std::array enum_names<mpm::WallRule>{"slip", "stick", "separate"};
template <>
constexpr std::array enum_names<mpm::PistonMotion>{"solitary", "sine"};
template <>
constexpr std::array enum_names<mpm::Moduli>{"plane_strain", "paper"};
template <>
constexpr std::array enum_names<mpm::ShearReturn>{"pressure", "trace"};
template <>
constexpr std::array enum_names<mpm::WaterScheme>{"density", "paper"};
template <>
constexpr std::array enum_names<mpm::WaterTension>{"separate", "paper"};
template <>
constexpr std::array enum_names<mpm::Transfer>{"apic", "restored"};
template <>
constexpr std::array enum_names<mpm::BodyContact>{"stick", "slip"};
template <>
constexpr std::array enum_names<IceBase>{"given", "bed", "floating"};
template <>
constexpr std::array enum_names<BedShape>{"straight", "smooth"};
template <>
constexpr std::array enum_names<Nodata>{"refuse", "fill"};
template <>
constexpr std::array enum_names<IceColors>{"damage", "iceberg"};
template <>
constexpr std::array enum_names<Pattern>{"lattice", "blue_noise"};
template <>
constexpr std::array enum_names<Softening>{"paper", "crack_band"};
template <>
constexpr std::array enum_names<HardeningLimit>{"start", "none"};
template <>
constexpr std::array enum_names<analysis::WaveKind>{"standing", "solitary"};
template <>
constexpr std::array enum_names<Precision>{"float", "double"};

template <class Enum>
std::vector<std::string> quoted_names() {
    std::vector<std::string> names;
    for (const char* name : enum_names<Enum>) names.push_back(quoted_text(name));
    return names;
}

std::string with_unit(std::string_view text, std::string_view unit) {
    return unit.empty() ? std::string(text) : std::string(text) + " " + std::string(unit);
}

// The convert functions return true where the TOML value has the member's type.

bool convert(const Value& value, double& to) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) to = static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value)) to = *number;
    return std::holds_alternative<std::int64_t>(value) || std::holds_alternative<double>(value);
}

bool convert(const Value& value, bool& to) {
    const auto* truth = std::get_if<bool>(&value);
    if (truth != nullptr) to = *truth;
    return truth != nullptr;
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

template <class Same>
requires(std::is_same_v<Same, std::string> ||
         std::is_same_v<Same, std::vector<double>>) bool convert(const Value& value, Same& to) {
    const auto* same = std::get_if<Same>(&value);
    if (same != nullptr) to = *same;
    return same != nullptr;
}

bool convert(const Value& value, Points& to) {
    const auto* points = std::get_if<Points>(&value);
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (points != nullptr) to = *points;
    if (numbers == nullptr) return points != nullptr;
    to.clear();
    for (const double number : *numbers) to.push_back({number});
    return true;
}

bool convert(const Value& value, std::vector<std::string>& to) {
    const auto* words = std::get_if<std::vector<std::string>>(&value);
    const auto* empty = std::get_if<std::vector<double>>(&value);
    if (words != nullptr) to = *words;
    if (empty != nullptr && empty->empty()) to.clear();
    return words != nullptr || (empty != nullptr && empty->empty());
}

template <class Enum>
requires std::is_enum_v<Enum>
bool convert(const Value& value, Enum& to) {
    const auto* name = std::get_if<std::string>(&value);
    if (name == nullptr) return false;
    const auto found = std::ranges::find(enum_names<Enum>, *name);
    if (found == enum_names<Enum>.end()) return false;
    to = static_cast<Enum>(found - enum_names<Enum>.begin());
    return true;
}

template <class T>
std::string range_problem(const Key& key, const T& value) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
        const auto number = static_cast<double>(value);
        if (key.range.contains(number)) return {};
        const std::string rule = key.range.text(key.unit);
        return with_unit(number_text(number), key.unit) + " is out of range; it must be " +
               (rule.empty() || !std::isfinite(number) ? "a finite number" + (rule.empty() ? "" : " " + rule)
                                                       : rule);
    } else if constexpr (std::is_same_v<T, std::vector<double>> || std::is_same_v<T, Points>) {
        for (const auto& item : value) {
            if (auto problem = range_problem(key, item); !problem.empty()) return problem;
        }
    }
    return {};
}

std::string example_text(const Key& key) {
    const std::string example(key.example.empty() ? value_text(key, Scene{}) : key.example);
    return std::string(key.last_name()) + " = " + example;
}

// What a member's type is called.
struct TypeName {
    const Key& key;

    std::string operator()(const Member<bool>&) const { return "true or false"; }
    std::string operator()(const Member<double>&) const { return "a number"; }
    std::string operator()(const Member<int>&) const { return "a whole number"; }
    std::string operator()(const Member<std::uint64_t>&) const { return "a whole number of 0 or more"; }
    std::string operator()(const Member<std::string>&) const { return "text in quotes"; }
    std::string operator()(const Member<std::vector<double>>&) const {
        return key.per_dimension ? "a list with one number per dimension" : "a list of numbers";
    }
    std::string operator()(const Member<Points>&) const { return "a list of numbers or points"; }
    std::string operator()(const Member<std::vector<std::string>>&) const {
        return "a list of words in quotes";
    }
    template <class Enum>
    std::string operator()(const Member<Enum>&) const {
        return "one of " + enumeration(quoted_names<Enum>());
    }
};

struct Print {
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(double number) const { return number_text(number); }
    std::string operator()(int whole) const { return std::to_string(whole); }
    std::string operator()(std::uint64_t whole) const { return std::to_string(whole); }
    std::string operator()(const std::string& text) const { return quoted_text(text); }
    std::string operator()(const std::vector<double>& list) const { return list_text(list); }
    std::string operator()(const Points& list) const { return list_text(list); }
    std::string operator()(const std::vector<std::string>& list) const { return list_text(list); }
    template <class Enum>
    requires std::is_enum_v<Enum> std::string operator()(Enum value) const {
        return quoted_text(enum_names<Enum>[static_cast<std::size_t>(value)]);
    }
};

}  // namespace

bool Range::contains(double number) const {
    return std::isfinite(number) && number <= most && (open ? number > least : number >= least);
}

std::string Range::text(std::string_view unit) const {
    const bool below = std::isfinite(least);
    const bool above = std::isfinite(most);
    if (below && above && !open)
        return "from " + number_text(least) + " to " + with_unit(number_text(most), unit);
    std::string text;
    if (below) text = (open ? "above " : "at least ") + with_unit(number_text(least), unit);
    if (above) text += (below ? " and at most " : "at most ") + with_unit(number_text(most), unit);
    return text;
}

std::string type_text(const Key& key) {
    const std::string type = std::visit(TypeName{key}, key.member);
    return key.unit.empty() ? type : type + " in " + std::string(key.unit);
}

std::string value_text(const Key& key, const Scene& scene, std::size_t item) {
    return std::visit([&](const auto& member) { return Print{}(member.read(scene, item)); }, key.member);
}

std::string set_value(const Key& key, const Value& value, Scene& scene, std::size_t item) {
    return std::visit(
        [&](const auto& member) -> std::string {
            auto converted = member.read(scene, item);
            if (!convert(value, converted)) {
                return "needs " + type_text(key) + ", e.g. " + example_text(key) + "; got " + describe(value);
            }
            std::string problem = range_problem(key, converted);
            if (problem.empty()) member.write(scene, item) = std::move(converted);
            return problem;
        },
        key.member);
}

}  // namespace tidewater::scene
