// How the value of a key is checked against its type and range, and printed.
#include <cmath>

#include "scene/keys.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

std::string with_unit(std::string_view text, std::string_view unit) {
    return unit.empty() ? std::string(text) : std::string(text) + " " + std::string(unit);
}

// What is wrong with the numbers of a value, or an empty text. Other types are always in range.
struct RangeProblem {
    const Key& key;

    std::string operator()(double number) const {
        if (key.range.contains(number)) return {};
        const std::string rule = key.range.text(key.unit);
        const std::string finite = "a finite number" + (rule.empty() ? "" : " " + rule);
        return with_unit(number_text(number), key.unit) + " is out of range; it must be " +
               (rule.empty() || !std::isfinite(number) ? finite : rule);
    }
    std::string operator()(std::int64_t whole) const { return (*this)(static_cast<double>(whole)); }
    std::string operator()(const std::vector<double>& list) const {
        for (const double number : list) {
            if (auto problem = (*this)(number); !problem.empty()) return problem;
        }
        return {};
    }
    std::string operator()(const Points& list) const {
        for (const auto& point : list) {
            if (auto problem = (*this)(point); !problem.empty()) return problem;
        }
        return {};
    }
    std::string operator()(bool) const { return {}; }
    std::string operator()(const std::string&) const { return {}; }
    std::string operator()(const std::vector<std::string>&) const { return {}; }
    std::string operator()(const Foreign&) const { return {}; }
};

std::string example_text(const Key& key) {
    const std::string example(key.example.empty() ? value_text(key, Scene{}) : key.example);
    return std::string(key.last_name()) + " = " + example;
}

struct Print {
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(double number) const { return number_text(number); }
    std::string operator()(std::int64_t whole) const { return std::to_string(whole); }
    std::string operator()(const std::string& text) const { return quoted_text(text); }
    std::string operator()(const std::vector<double>& list) const { return list_text(list); }
    std::string operator()(const Points& list) const { return list_text(list); }
    std::string operator()(const std::vector<std::string>& list) const { return list_text(list); }
    std::string operator()(const Foreign& foreign) const { return foreign.description; }
};

// "one of "slip", "stick" or "separate"".
std::string choice_text(std::span<const std::string_view> names) {
    std::vector<std::string> quoted;
    for (const std::string_view name : names) quoted.push_back(quoted_text(name));
    return "one of " + enumeration(quoted);
}

}  // namespace

bool Range::contains(double number) const {
    if (infinite && std::isinf(number)) return number > 0.0;
    return std::isfinite(number) && number <= max && (open ? number > min : number >= min);
}

std::string Range::text(std::string_view unit) const {
    const bool below = std::isfinite(min);
    const bool above = std::isfinite(max);
    if (below && above && !open)
        return "from " + number_text(min) + " to " + with_unit(number_text(max), unit);
    std::string text;
    if (below) text = (open ? "above " : "at least ") + with_unit(number_text(min), unit);
    if (above) text += (below ? " and at most " : "at most ") + with_unit(number_text(max), unit);
    if (infinite) text += ", or inf";
    return text;
}

std::string type_text(const Key& key) {
    std::string type(key.member.type);
    if (!key.member.names.empty()) type = choice_text(key.member.names);
    if (key.per_dimension) type = "a list with one number per dimension";
    return key.unit.empty() ? type : type + " in " + std::string(key.unit);
}

std::string value_text(const Key& key, const Scene& scene, std::size_t item) {
    return std::visit(Print{}, key.member.get(scene, item));
}

std::string set_value(const Key& key, const Value& value, Scene& scene, std::size_t item) {
    const Value before = key.member.get(scene, item);
    if (!key.member.set(scene, item, value))
        return "needs " + type_text(key) + ", e.g. " + example_text(key) + "; got " + describe(value);
    std::string problem = std::visit(RangeProblem{key}, key.member.get(scene, item));
    if (!problem.empty()) key.member.set(scene, item, before);
    return problem;
}

}  // namespace tidewater::scene
