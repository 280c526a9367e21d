// How a scene is read: from the settings of the file and of --set to members, in order and complete.
#include <algorithm>

#include "core/error.h"
#include "core/files.h"
#include "scene/effects/effects.h"
#include "scene/keys.h"
#include "scene/point_file.h"
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
    for (const Key& key : all_keys()) {
        if (!key.retired) names.emplace_back(key.name);
    }
    return names;
}

std::string unknown_key(const std::string& name) {
    const std::string meant = nearest(name, key_names());
    return "unknown key; " + (meant.empty() ? "--help-scene lists all keys" : "did you mean " + meant + "?");
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

// Gives the scene as many items as the file has sections of each repeated key.
void make_items(const Document& document, Scene& scene) {
    for (const Key& key : all_keys()) {
        const auto found = document.sections.find(std::string(key.section()));
        if (key.repeated() && found != document.sections.end())
            key.member.resize(scene, std::max<std::size_t>(found->second, 1));
    }
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
    const auto list = std::get<std::vector<double>>(key.member.get(scene, setting.item));
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

// Reads a table of points from the file that the key names. From then on it is as if it stood in the scene.
void read_points(Reading& reading, const Key& key) {
    const std::string target(key.points_of), file_key(key.name);
    const auto file = std::get<std::string>(key.member.get(reading.scene, 0));
    if (!reading.usable({file_key}) || !reading.places.contains(file_key) || file.empty()) return;
    const Member& points = find_key(target)->member;
    const bool given = !std::get<std::vector<double>>(points.get(reading.scene, 0)).empty();
    if (given && reading.places.contains(target))
        return reading.report(file_key, "the scene has " + target + " as well; remove one of them");
    try {
        points.set(reading.scene, 0,
                   read_point_file(std::filesystem::absolute(reading.file).parent_path() / file));
        reading.places[target] = reading.places[file_key];
        key.member.set(reading.scene, 0, std::string());
    } catch (const Error& error) {
        reading.report(file_key, error.what());
        reading.spoil(target);
    }
}

void read_point_files(Reading& reading) {
    if (!reading.usable({"effects"})) return;
    for (const Key& key : all_keys()) {
        if (!key.points_of.empty() && key.applies(reading.scene)) read_points(reading, key);
    }
}

// Files are named from the scene's folder. "NETCDF:file:variable" as GDAL has it.
void find_files(Reading& reading) {
    const std::filesystem::path folder = std::filesystem::absolute(reading.file).parent_path();
    for (const Key& key : all_keys()) {
        if (!key.file || !reading.places.contains(key.name) || !reading.usable({key.name})) continue;
        const auto text = std::get<std::string>(key.member.get(reading.scene, 0));
        if (text.empty()) continue;
        const FilePart part = file_part(text);
        const std::filesystem::path path = folder / part.path;  // itself where it is absolute
        if (!std::filesystem::is_regular_file(path)) {
            reading.report(key.name, path.string() + ": no such file; paths count from the scene's folder");
            reading.spoil(std::string(key.name));
        }
        key.member.set(reading.scene, 0, part.before + path.lexically_normal().string() + part.after);
    }
}

}  // namespace

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
    const Document document = parse_toml(read_text(file), repeated_sections());
    for (const auto& [line, problem] : document.problems) {
        reading.problems.push_back(reading.file + ":" + std::to_string(line) + ": " + problem);
    }
    if (!document.readable) throw SceneError(joined(reading.problems));

    make_items(document, reading.scene);
    std::vector<Setting> settings = settings_of(document.entries, overrides, reading.file, reading.scene);
    for (Setting& setting : settings) apply(setting, reading);
    check_effects(settings, reading);
    check_places(settings, reading);
    for (const Setting& setting : settings) {
        if (!setting.problem.empty()) reading.add(setting.place + ": " + setting.problem);
    }
    read_point_files(reading);
    check_missing(reading);
    find_files(reading);
    derive_scene(reading);
    check_scene(reading);
    if (!reading.problems.empty()) throw SceneError(joined(reading.problems));
    return reading.scene;
}

}  // namespace tidewater::scene
