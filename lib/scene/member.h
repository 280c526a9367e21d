// The member of a Scene that holds a key's value, read and written as the TOML value that a file would have.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/enum_names.h"
#include "scene/scene.h"
#include "scene/toml_document.h"

namespace tidewater::scene {

// A member of any type. `item` counts the sections of a key that may stand in several, from 0; other keys
// ignore it.
struct Member {
    std::string_view type;                    // "a number"; empty for an enum
    std::span<const std::string_view> names;  // the values of an enum; empty for every other type
    Value (*get)(const Scene& scene, std::size_t item);
    // Returns false, and leaves the scene as it is, if the value is of another type.
    bool (*set)(Scene& scene, std::size_t item, const Value& value);

    // How many sections the scene has, and how to change that. Null for a section that stands once.
    std::size_t (*count)(const Scene& scene) = nullptr;
    void (*resize)(Scene& scene, std::size_t count) = nullptr;
};

// What messages call a type.
template <class T>
inline constexpr std::string_view type_name = "";
template <>
inline constexpr std::string_view type_name<bool> = "true or false";
template <>
inline constexpr std::string_view type_name<double> = "a number";
template <>
inline constexpr std::string_view type_name<int> = "a whole number";
template <>
inline constexpr std::string_view type_name<std::uint64_t> = "a whole number of 0 or more";
template <>
inline constexpr std::string_view type_name<std::string> = "text in quotes";
template <>
inline constexpr std::string_view type_name<std::vector<double>> = "a list of numbers";
template <>
inline constexpr std::string_view type_name<Points> = "a list of numbers or points";
template <>
inline constexpr std::string_view type_name<std::vector<std::string>> = "a list of words in quotes";

// Each overload sets `to` and returns true if the value has its type, and otherwise leaves it as it is.
bool convert(const Value& value, bool& to);
bool convert(const Value& value, double& to);
bool convert(const Value& value, int& to);  // clamped to ±10⁹
bool convert(const Value& value, std::uint64_t& to);
bool convert(const Value& value, std::string& to);
bool convert(const Value& value, std::vector<double>& to);
bool convert(const Value& value, Points& to);
bool convert(const Value& value, std::vector<std::string>& to);

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

// An enum that may be unset; an empty text unsets it.
template <class Enum>
bool convert(const Value& value, std::optional<Enum>& to) {
    Enum named{};
    const auto* name = std::get_if<std::string>(&value);
    if (name != nullptr && name->empty()) {
        to.reset();
        return true;
    }
    if (!convert(value, named)) return false;
    to = named;
    return true;
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
Value to_value(const T& member) {
    if constexpr (std::is_enum_v<T>)
        return std::string(enum_names<T>[static_cast<std::size_t>(member)]);
    else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
        return static_cast<std::int64_t>(member);
    else if constexpr (is_optional<T>)
        return member ? to_value(*member) : Value(std::string());
    else
        return member;
}

// The Member that Place::of(scene, item) reaches.
template <class Place>
constexpr Member member_at() {
    using T = std::remove_cvref_t<decltype(Place::of(std::declval<Scene&>(), 0))>;
    Member member{
        .type = type_name<T>,
        .names = {},
        .get = [](const Scene& scene, std::size_t item) { return to_value(Place::of(scene, item)); },
        .set = [](Scene& scene, std::size_t item,
                  const Value& value) { return convert(value, Place::of(scene, item)); }};
    if constexpr (std::is_enum_v<T>) member.names = enum_names<T>;
    if constexpr (is_optional<T>) member.names = enum_names<typename T::value_type>;
    return member;
}

// member<&Scene::domain, &Scene::Domain::size>() reaches scene.domain.size.
template <auto... path>
struct PathPlace {
    static auto& of(auto& scene, std::size_t) { return (scene.*....*path); }
};
template <auto... path>
constexpr Member member() {
    return member_at<PathPlace<path...>>();
}

// item_member<&Scene::blocks, &Block::size>() reaches scene.blocks[item].size: a key whose section may stand
// in the file several times. The scene always has one item at least.
template <auto items, auto last>
struct ItemPlace {
    static auto& of(auto& scene, std::size_t item) { return (scene.*items)[item].*last; }
};
template <auto items, auto last>
constexpr Member item_member() {
    Member member = member_at<ItemPlace<items, last>>();
    member.count = [](const Scene& scene) { return (scene.*items).size(); };
    member.resize = [](Scene& scene, std::size_t count) { (scene.*items).resize(count); };
    return member;
}

}  // namespace tidewater::scene
