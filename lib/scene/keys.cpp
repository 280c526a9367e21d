#include "scene/keys.h"

#include <algorithm>
#include <vector>

#include "scene/effects/effects.h"
#include "scene/keys_parts.h"

namespace tidewater::scene {

std::span<const Key> all_keys() {
    static const std::vector<Key> keys = [] {
        std::vector<Key> all;
        const auto append = [&](std::span<const Key> part) {
            all.insert(all.end(), part.begin(), part.end());
        };
        append(scene_keys());
        for (const Effect* effect : all_effects()) append(effect->keys);
        append(simulate_keys());
        append(postprocess_keys());
        return all;
    }();
    return keys;
}

const Key* find_key(std::string_view name) {
    const auto keys = all_keys();
    const auto found = std::ranges::find(keys, name, &Key::name);
    return found == keys.end() ? nullptr : &*found;
}

std::span<const std::string> repeated_sections() {
    static const std::vector<std::string> sections = [] {
        std::vector<std::string> all;
        for (const Key& key : all_keys()) {
            if (key.repeated() && std::ranges::count(all, key.section()) == 0)
                all.emplace_back(key.section());
        }
        return all;
    }();
    return sections;
}

std::string_view Key::section() const {
    const auto dot = name.find('.');
    return dot == name.npos ? std::string_view() : name.substr(0, dot);
}

std::string_view Key::last_name() const { return name.substr(name.rfind('.') + 1); }

bool Key::repeated() const { return member.count != nullptr; }

std::size_t Key::count(const Scene& scene) const { return repeated() ? member.count(scene) : 1; }

std::string Key::name_of(std::size_t item, const Scene& scene) const {
    if (count(scene) == 1) return std::string(name);
    return std::string(section()) + "." + std::to_string(item + 1) + "." + std::string(last_name());
}

bool Key::applies(const Scene& scene) const {
    return (effect.empty() || scene.has(effect)) && (!only_3d || scene.dimension == 3);
}

}  // namespace tidewater::scene
