#include "scene/keys.h"

#include <algorithm>
#include <array>
#include <vector>

#include "scene/keys_parts.h"

namespace tidewater::scene {

std::span<const Key> all_keys() {
    static const std::vector<Key> keys = [] {
        std::vector<Key> all;
        for (const auto part : {tank_keys(), glacier_keys(), run_keys(), postprocess_keys()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return keys;
}

const Key* find_key(std::string_view name) {
    const auto keys = all_keys();
    const auto found = std::ranges::find(keys, name, &Key::name);
    return found == keys.end() ? nullptr : &*found;
}

std::span<const std::string> known_effects() {
    static const std::array<std::string, 17> effects{
        "water", "wave",  "rigid", "ice",  "fracture", "cliff",  "undercut", "crevasses", "cracks",
        "dem",   "shelf", "bed",   "push", "piston",   "outlet", "sponge",   "settle"};
    return effects;
}

std::string_view Key::section() const {
    const auto dot = name.find('.');
    return dot == name.npos ? std::string_view() : name.substr(0, dot);
}

std::string_view Key::last_name() const { return name.substr(name.rfind('.') + 1); }

bool Key::repeated() const { return section() == "block"; }

std::size_t Key::count(const Scene& scene) const { return repeated() ? scene.blocks.size() : 1; }

std::string Key::name_of(std::size_t item, const Scene& scene) const {
    if (count(scene) == 1) return std::string(name);
    return std::string(section()) + "." + std::to_string(item + 1) + "." + std::string(last_name());
}

bool Key::applies(const Scene& scene) const {
    return (effect.empty() || scene.has(effect)) && (!only_3d || scene.dimension == 3);
}

}  // namespace tidewater::scene
