// A scene while it is being read: what is set so far, where, and what is wrong with it.
#pragma once

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace tidewater::scene {

struct Reading {
    std::string file;
    Scene scene;
    // Where each key was set: "x.toml:12: water.depth", "--set water.depth=2".
    std::map<std::string, std::string, std::less<>> places;
    // Keys that are missing or wrong. Checks that need them are left out.
    std::set<std::string, std::less<>> unusable;
    std::vector<std::string> problems;

    // The name of a key in a repeated section, such as "block.size", stands for that of every item.
    bool usable(std::initializer_list<std::string_view> keys) const;

    // Marks a key, in its full name, as unusable.
    void spoil(const std::string& key);

    // Appends a line unless it is there already: one --set may be wrong for several items.
    void add(const std::string& problem);

    // Appends "<where the key was set>: <problem>".
    void report(std::string_view key, const std::string& problem);
};

// Reports a scene that names `effect` but not `needed`, so that `consequence`.
void require_effect(Reading& reading, std::string_view effect, std::string_view needed,
                    std::string_view consequence);

// Reports a scene that names both effects, which `why` forbids.
void refuse_pair(Reading& reading, std::string_view effect, std::string_view other, std::string_view why);

// Sets the keys that follow from others, effect by effect.
void derive_scene(Reading& reading);

// Checks the keys against each other: those of the tank, of each effect, and of the simulation.
void check_scene(Reading& reading);

// "x", "y" or "z".
const char* axis_name(std::size_t axis, int dimension);

// The largest difference between two lengths that count as equal, over a cell's width.
inline constexpr double tolerance = 1e-6;

}  // namespace tidewater::scene
