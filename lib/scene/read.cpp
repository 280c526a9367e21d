#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

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
    std::size_t item;     // of a repeated section, from 0
    std::string problem;  // empty: none
};

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
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

// A key's name without the number of its section, "block.size" for "block.2.size", and that number if any.
struct Numbered {
    std::string name;
    std::optional<std::size_t> number;
};

Numbered split_number(const std::string& name) {
    const auto first = name.find('.'), second = name.rfind('.');
    if (first == second) return {name, {}};
    std::size_t number = 0;
    const char *from = name.data() + first + 1, *to = name.data() + second;
    const auto [end, error] = std::from_chars(from, to, number);
    if (error != std::errc() || end != to) return {name, {}};
    return {name.substr(0, first) + name.substr(second), number};
}

// A setting of a repeated section without a number is one of every item.
void append_settings(const std::string& name, const std::string& place, const Value& value,
                     const Scene& scene, std::vector<Setting>& settings) {
    const auto [plain, number] = split_number(name);
    const Key* key = find_key(plain);
    if (key == nullptr || (number && !key->repeated())) {
        settings.push_back({name, place, value, nullptr, 0, unknown_key(plain)});
        return;
    }
    const std::size_t count = key->count(scene);
    if (number && (*number < 1 || *number > count)) {
        const std::string section(key->section());
        settings.push_back({name, place, value, nullptr, 0,
                            "there is no " + section + " " + std::to_string(*number) + "; the scene has " +
                                std::to_string(count) + ", each under a [[" + section + "]] of its own"});
        return;
    }
    const std::size_t first = number ? *number - 1 : 0, last = number ? *number : count;
    for (std::size_t item = first; item < last; ++item)
        settings.push_back({key->name_of(item, scene), place, value, key, item, {}});
}

std::vector<Setting> settings_of(const std::vector<Entry>& entries, const std::vector<Override>& overrides,
                                 const std::string& file, const Scene& scene) {
    std::vector<Setting> settings;
    for (const Entry& entry : entries) {
        const std::string place = file + ":" + std::to_string(entry.line) + ": " + entry.key;
        append_settings(entry.key, place, entry.value, scene, settings);
    }
    for (const Override& set : overrides) {
        std::vector<Setting> later;
        append_settings(set.key, "--set " + set.key + "=" + set.value, parse_value(set.value), scene, later);
        std::erase_if(settings, [&](const Setting& earlier) {
            return std::ranges::count(later, earlier.name, &Setting::name) > 0;
        });
        settings.insert(settings.end(), later.begin(), later.end());
    }
    return settings;
}

void apply(Setting& setting, Reading& reading) {
    if (setting.key == nullptr) return;
    reading.places[setting.name] = setting.place;
    setting.problem = set_value(*setting.key, setting.value, reading.scene, setting.item);
    if (!setting.problem.empty()) reading.spoil(setting.name);
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
std::string misplaced(const Setting& setting, const Reading& reading) {
    const Scene& scene = reading.scene;
    const Key& key = *setting.key;
    if (reading.usable({"effects"}) && !key.effect.empty() && !scene.has(key.effect)) {
        const std::string effect = quoted_text(key.effect);
        return "belongs to the effect " + effect + "; add " + effect + " to effects or remove the key";
    }
    if (!reading.usable({"dimension"})) return {};
    if (key.only_3d && scene.dimension == 2) return "exists in 3D only; remove it or set dimension = 3";
    if (!key.per_dimension || !reading.usable({setting.name})) return {};
    const auto& list = std::get<Member<std::vector<double>>>(key.member).read(scene, setting.item);
    if (list.size() == static_cast<std::size_t>(scene.dimension)) return {};
    if (list.empty() && !key.required) return {};
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
        std::string problem = misplaced(setting, reading);
        if (problem.empty()) continue;
        setting.problem = std::move(problem);
        reading.spoil(setting.name);
    }
}

std::string under_section(const Key& key, const Scene& scene) {
    if (key.section().empty()) return {};
    const std::string section = "[" + std::string(key.section()) + "]";
    return " under " + (key.count(scene) > 1 ? "its [" + section + "]" : section);
}

void check_missing(Reading& reading) {
    const bool effects_known = reading.usable({"effects"});
    for (const Key& key : all_keys()) {
        const bool wanted = key.effect.empty() || (effects_known && reading.scene.has(key.effect));
        if (!key.required || !wanted || reading.places.contains(key.instead)) continue;
        for (std::size_t item = 0; item < key.count(reading.scene); ++item) {
            const std::string name = key.name_of(item, reading.scene);
            if (reading.places.contains(name)) continue;
            reading.report(name, "missing; add it" + under_section(key, reading.scene) + ", e.g. " +
                                     std::string(key.last_name()) + " = " + std::string(key.example));
            reading.spoil(name);
        }
    }
}

// An empty list is that of zeros.
void fill_velocities(Reading& reading) {
    if (!reading.usable({"dimension"})) return;
    for (Scene::Block& block : reading.scene.blocks) {
        if (block.velocity.empty())
            block.velocity.assign(static_cast<std::size_t>(reading.scene.dimension), 0.0);
    }
}

// Files are named from the scene's folder. "NETCDF:file:variable" as GDAL has it.
void find_files(Reading& reading) {
    const std::filesystem::path folder = std::filesystem::absolute(reading.file).parent_path();
    for (const Key& key : all_keys()) {
        if (!key.file || !reading.places.contains(key.name) || !reading.usable({key.name})) continue;
        std::string& text = std::get<Member<std::string>>(key.member).write(reading.scene, 0);
        if (text.empty()) continue;
        const FilePart part = file_part(text);
        const std::filesystem::path path = folder / part.path;  // itself where it is absolute
        if (!std::filesystem::is_regular_file(path)) {
            reading.report(key.name, path.string() + ": no such file; paths count from the scene's folder");
            reading.spoil(std::string(key.name));
        }
        text = part.before + path.lexically_normal().string() + part.after;
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

void Reading::spoil(const std::string& key) {
    unusable.insert(key);
    unusable.insert(split_number(key).name);
}

void Reading::add(const std::string& problem) {
    if (std::ranges::count(problems, problem) == 0) problems.push_back(problem);
}

void Reading::report(std::string_view key, const std::string& problem) {
    const auto place = places.find(key);
    add((place == places.end() ? file + ": " + std::string(key) : place->second) + ": " + problem);
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

    const auto blocks = document.sections.find("block");
    if (blocks != document.sections.end())
        reading.scene.blocks.resize(std::max<std::size_t>(blocks->second, 1));
    std::vector<Setting> settings = settings_of(document.entries, overrides, reading.file, reading.scene);
    for (Setting& setting : settings) apply(setting, reading);
    check_effects(settings, reading);
    check_places(settings, reading);
    for (const Setting& setting : settings) {
        if (!setting.problem.empty()) reading.add(setting.place + ": " + setting.problem);
    }
    read_profiles(reading);
    check_missing(reading);
    find_files(reading);
    derive_glacier(reading);
    derive(reading);
    fill_velocities(reading);
    check_scene(reading);
    if (!reading.problems.empty()) throw SceneError(joined(reading.problems));
    return reading.scene;
}

}  // namespace tidewater::scene
