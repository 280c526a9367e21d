#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/files.h"
#include "scene/keys.h"
#include "scene/reading.h"
#include "scene/scene.h"
#include "scene/text.h"
#include "scene/toml_document.h"

namespace tidewater::scene {
namespace {

// One key as the user set it, and what is wrong with it.
struct Setting {
    std::string name;
    std::string place;
    Value value;
    const Key* key;       // null: unknown
    std::string problem;  // empty: none
};

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

std::vector<Setting> settings_of(const std::vector<Entry>& entries, const std::vector<Override>& overrides,
                                 const std::string& file) {
    std::vector<Setting> settings;
    for (const Entry& entry : entries) {
        const std::string place = file + ":" + std::to_string(entry.line) + ": " + entry.key;
        settings.push_back({entry.key, place, entry.value, find_key(entry.key), {}});
    }
    for (const Override& set : overrides) {
        std::erase_if(settings, [&](const Setting& earlier) { return earlier.name == set.key; });
        const std::string place = "--set " + set.key + "=" + set.value;
        settings.push_back({set.key, place, parse_value(set.value), find_key(set.key), {}});
    }
    return settings;
}

std::vector<std::string> key_names() {
    std::vector<std::string> names;
    for (const Key& key : all_keys()) names.emplace_back(key.name);
    return names;
}

std::string unknown_key(const std::string& name) {
    const std::string meant = nearest(name, key_names());
    return "unknown key; " + (meant.empty() ? "--help-scene lists all keys" : "did you mean " + meant + "?");
}

void apply(Setting& setting, Reading& reading) {
    if (setting.key == nullptr) {
        setting.problem = unknown_key(setting.name);
        return;
    }
    reading.places[setting.name] = setting.place;
    setting.problem = set_value(*setting.key, setting.value, reading.scene);
    if (!setting.problem.empty()) reading.unusable.insert(setting.name);
}

std::string unknown_effect(const std::string& effect) {
    const std::string meant = nearest(effect, known_effects());
    return "unknown effect " + quoted_text(effect) + "; " +
           (meant.empty() ? "known are " + enumeration(known_effects(), "and")
                          : "did you mean " + quoted_text(meant) + "?");
}

// What is wrong with the list of effects, or an empty text.
std::string effects_problem(const std::vector<std::string>& effects) {
    if (effects.empty()) return "names none, so there would be no particles; e.g. effects = [\"water\"]";
    for (const std::string& effect : effects) {
        if (std::ranges::count(known_effects(), effect) == 0) return unknown_effect(effect);
        if (std::ranges::count(effects, effect) > 1) return quoted_text(effect) + " is named twice";
    }
    return {};
}

// A key that the scene's effects or dimension leave no place for, or a list of the wrong length.
std::string misplaced(const Key& key, const Reading& reading) {
    const Scene& scene = reading.scene;
    if (reading.usable({"effects"}) && !key.effect.empty() && !scene.has(key.effect)) {
        const std::string effect = quoted_text(key.effect);
        return "belongs to the effect " + effect + "; add " + effect + " to effects or remove the key";
    }
    if (!reading.usable({"dimension"})) return {};
    if (key.only_3d && scene.dimension == 2) return "exists in 3D only; remove it or set dimension = 3";
    if (!key.per_dimension || !reading.usable({key.name})) return {};
    const auto& list = std::get<Member<std::vector<double>>>(key.member).read(scene);
    if (list.size() == static_cast<std::size_t>(scene.dimension)) return {};
    return "has " + std::to_string(list.size()) + (list.size() == 1 ? " number" : " numbers") +
           ", but dimension = " + std::to_string(scene.dimension) + " needs " +
           (scene.dimension == 2 ? "2: (x, z)" : "3: (x, y, z)");
}

void check_effects(std::vector<Setting>& settings, Reading& reading) {
    const auto named = std::ranges::find(settings, "effects", &Setting::name);
    if (named == settings.end()) {
        reading.unusable.insert("effects");
    } else if (named->problem.empty()) {
        named->problem = effects_problem(reading.scene.effects);
        if (!named->problem.empty()) reading.unusable.insert("effects");
    }
}

void check_places(std::vector<Setting>& settings, Reading& reading) {
    for (Setting& setting : settings) {
        if (setting.key == nullptr) continue;
        std::string problem = misplaced(*setting.key, reading);
        if (problem.empty()) continue;
        setting.problem = std::move(problem);
        reading.unusable.insert(setting.name);
    }
}

void check_missing(Reading& reading) {
    const bool effects_known = reading.usable({"effects"});
    for (const Key& key : all_keys()) {
        const bool wanted = key.effect.empty() || (effects_known && reading.scene.has(key.effect));
        if (!key.required || !wanted || reading.places.contains(key.name)) continue;
        if (reading.places.contains(key.instead)) continue;
        const std::string section =
            key.section().empty() ? "" : " under [" + std::string(key.section()) + "]";
        reading.report(key.name, "missing; add it" + section + ", e.g. " + std::string(key.last_name()) +
                                     " = " + std::string(key.example));
        reading.unusable.emplace(key.name);
    }
}

// Keys that follow from others.
void derive(Reading& reading) {
    Scene& scene = reading.scene;
    if (!reading.usable({"effects"}) || !scene.has("water")) return;
    const bool given = reading.places.contains("water.depth");
    if (!given) reading.unusable.insert("water.depth");  // until it is known
    if (!reading.usable({"dimension", "water.submergence", "domain.size"})) return;
    if (scene.water.submergence < 0.0) {
        if (!given && reading.places.contains("water.submergence"))
            reading.report("water.depth", "missing; add it, or a water.submergence of 0 or more");
        return;
    }
    if (!scene.has("ice")) {
        reading.report("water.submergence",
                       "is measured on ice, and effects does not name \"ice\"; use water.depth");
        return;
    }
    if (!reading.usable({"ice.size", "ice.corner"})) return;
    const double depth = scene.ice.corner.back() + scene.water.submergence * scene.ice.size.back();
    if (given && std::abs(depth - scene.water.depth) > 1e-9 * depth) {
        reading.report("water.depth", number_text(scene.water.depth) + " m, but water.submergence says " +
                                          number_text(depth) + " m; remove one of them");
    }
    if (depth > 0.0 && depth <= scene.domain.size.back()) {
        scene.water.depth = depth;
        reading.unusable.erase("water.depth");
        return;
    }
    reading.report("water.submergence",
                   "puts the still water at " + number_text(depth) +
                       " m, which must be above 0 m and at most the tank's height; change "
                       "it, ice.corner or domain.size");
}

}  // namespace

bool Reading::usable(std::initializer_list<std::string_view> keys) const {
    return std::ranges::none_of(keys, [&](std::string_view key) { return unusable.contains(key); });
}

void Reading::report(std::string_view key, const std::string& problem) {
    const auto place = places.find(key);
    problems.push_back((place == places.end() ? file + ": " + std::string(key) : place->second) + ": " +
                       problem);
}

Override parse_override(std::string_view text) {
    const auto equals = text.find('=');
    if (equals == text.npos || equals == 0) {
        throw SceneError("--set " + std::string(text) +
                         ": needs key=value, e.g. --set domain.cell_size=0.02");
    }
    return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides) {
    Reading reading;
    reading.file = file.string();
    const Document document = parse_toml(read_text(file));
    for (const auto& [line, problem] : document.problems) {
        reading.problems.push_back(reading.file + ":" + std::to_string(line) + ": " + problem);
    }
    if (!document.readable) throw SceneError(joined(reading.problems));

    std::vector<Setting> settings = settings_of(document.entries, overrides, reading.file);
    for (Setting& setting : settings) apply(setting, reading);
    check_effects(settings, reading);
    check_places(settings, reading);
    for (const Setting& setting : settings) {
        if (!setting.problem.empty()) reading.problems.push_back(setting.place + ": " + setting.problem);
    }
    check_missing(reading);
    derive(reading);
    check_scene(reading);
    if (!reading.problems.empty()) throw SceneError(joined(reading.problems));
    return reading.scene;
}

}  // namespace tidewater::scene
