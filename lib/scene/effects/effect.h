// What one effect tells the rest of lib/scene. Each effect defines its entry in its own file; effects.cpp
// lists them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys.h"

namespace tidewater::scene {

struct Reading;

// One edge of a body, in m, and the key that sets it.
struct Edge {
    double length = 0.0;
    std::string key;
};

// A box that is filled with particles. The grid must resolve each of its edges.
struct Body {
    std::string name;  // "the ice", "block 2"
    std::vector<Edge> edges;
};

// A function that an effect does not need stays null. Each is called only for scenes that name the effect.
struct Effect {
    // As `effects` names it.
    std::string_view name;

    // Its keys in the order in which they are printed.
    std::span<const Key> keys;

    // Sets the keys that follow from others, and reports where they cannot. Runs from the last effect of the
    // table to the first: water.submergence needs the ice's box, so the ice comes before the water.
    void (*derive)(Reading&) = nullptr;

    // Reports what is wrong between its keys, and between them and the rest of the scene. A problem that
    // involves two effects is checked by the effect whose key the message names.
    void (*check)(Reading&) = nullptr;

    // What is allowed but probably not meant, one line each. Only asked of scenes that are in order.
    std::vector<std::string> (*warnings)(const Scene&) = nullptr;

    // What it fills with particles. The keys may still be wrong: an edge counts once its key is usable.
    std::vector<Body> (*bodies)(const Scene&) = nullptr;
};

}  // namespace tidewater::scene
