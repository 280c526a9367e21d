#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "core/files.h"
#include "core/hash.h"
#include "scene/keys.h"
#include "scene/scene.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

// The unit, if there is one, and the help: "m; the tank is the box ...".
std::string comment(const Key& key) {
    if (key.unit.empty()) return std::string(key.help);
    return std::string(key.unit) + "; " + std::string(key.help);
}

std::string stage_names(unsigned stages) {
    std::string names;
    for (const Stage stage : {Stage::geometry, Stage::simulate, Stage::postprocess}) {
        if ((stages & by(stage)) == 0) continue;
        names += (names.empty() ? "" : ", ") + std::string(stage_name(stage));
    }
    return names;
}

// A file by its name and a hash of what it holds, so that its folder does not count.
std::string file_line(const Key& key, const Scene& scene) {
    const std::filesystem::path path = file_part(std::get<std::string>(key.member.get(scene, 0))).path;
    std::error_code error;
    const bool there = std::filesystem::is_regular_file(path, error);
    return std::string(key.name) + " = " + quoted_text(path.filename().string()) +
           (there ? "  # holds " + hash_hex(hash_text(read_text(path))) : "") + "\n";
}

std::string plain_lines(const Key& key, const Scene& scene) {
    if (key.file) return file_line(key, scene);
    std::string text;
    for (std::size_t item = 0; item < key.count(scene); ++item)
        text += key.name_of(item, scene) + " = " + value_text(key, scene, item) + "\n";
    return text;
}

// "[water]", "[[block]]"; nothing for the keys without a section.
std::string header(const Key& key, const Scene& scene) {
    if (key.section().empty()) return {};
    const std::string name = "[" + std::string(key.section()) + "]";
    return "\n" + (key.count(scene) > 1 ? "[" + name + "]" : name) + "\n";
}

// The keys of one section that apply, below its header; nothing if there are none.
std::string section_text(std::span<const Key> section, const Scene& scene, std::size_t item) {
    constexpr std::size_t comment_column = 40;
    std::string text;
    for (const Key& key : section) {
        if (!key.applies(scene) || key.retired) continue;
        std::string line = std::string(key.last_name()) + " = " + value_text(key, scene, item);
        line.resize(std::max(line.size(), comment_column), ' ');
        text += line + "  # " + comment(key) + "\n";
    }
    return text.empty() ? text : header(section.front(), scene) + text;
}

// The keys of `stages` that apply to the scene and change results, one "section.key = value" a line.
std::string plain_text(const Scene& scene, unsigned stages) {
    std::string text;
    for (const Key& key : all_keys()) {
        if ((key.stages & stages) != 0 && key.changes_results && !key.retired && key.applies(scene))
            text += plain_lines(key, scene);
    }
    return text;
}

std::string reference_entry(const Key& key) {
    std::string text = std::string(key.name) + "\n    " + type_text(key);
    const std::string range = key.range.text("");
    if (!range.empty()) text += ", " + range;
    text += key.required ? "; required, e.g. " + std::string(key.example)
                         : "; default " + value_text(key, Scene{});
    if (!key.effect.empty()) text += "; with effect \"" + std::string(key.effect) + "\"";
    if (key.only_3d) text += "; in 3D";
    return text + "\n    " + std::string(key.help) + "\n    read by " + stage_names(key.stages) + "\n";
}

}  // namespace

std::string resolved_text(const Scene& scene) {
    std::string text;
    const std::span<const Key> keys = all_keys();
    for (auto first = keys.begin(); first != keys.end();) {
        const auto last = std::find_if(first, keys.end(),
                                       [&](const Key& key) { return key.section() != first->section(); });
        for (std::size_t item = 0; item < first->count(scene); ++item)
            text += section_text({first, last}, scene, item);
        first = last;
    }
    return text;
}

std::string stage_part(const Scene& scene, Stage stage) { return plain_text(scene, by(stage)); }

std::string scene_hash(const Scene& scene, Stage stage) {
    const unsigned up_to_stage = 2 * by(stage) - 1;
    return hash_hex(hash_text(plain_text(scene, up_to_stage)));
}

std::string values_of(const Scene& scene, std::span<const std::string_view> names) {
    std::string text;
    for (const std::string_view name : names) {
        bool known = false;
        for (const Key& key : all_keys()) {
            if (key.name != name && !(name.ends_with('.') && key.name.starts_with(name))) continue;
            known = true;
            if (key.changes_results && !key.retired && key.applies(scene)) text += plain_lines(key, scene);
        }
        if (!known)
            throw std::invalid_argument(std::string(name) +
                                        ": a scene has neither such a key nor such a section");
    }
    return text;
}

std::string key_reference() {
    std::string text = "The keys of a scene file, each usable as --set key=value too.\n";
    for (const Key& key : all_keys()) {
        if (!key.retired) text += "\n" + reference_entry(key);
    }
    return text;
}

}  // namespace tidewater::scene
