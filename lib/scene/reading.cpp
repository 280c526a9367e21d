#include "scene/reading.h"

#include <algorithm>

#include "scene/text.h"

namespace tidewater::scene {

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

void require_effect(Reading& reading, std::string_view effect, std::string_view needed,
                    std::string_view consequence) {
    if (!reading.scene.has(effect) || reading.scene.has(needed)) return;
    reading.report("effects", "names " + quoted_text(effect) + " but not " + quoted_text(needed) + ", so " +
                                  std::string(consequence) + "; add " + quoted_text(needed) + " or remove " +
                                  quoted_text(effect));
}

void refuse_pair(Reading& reading, std::string_view effect, std::string_view other, std::string_view why) {
    if (!reading.scene.has(effect) || !reading.scene.has(other)) return;
    reading.report("effects", "names " + quoted_text(effect) + " and " + quoted_text(other) + ": " +
                                  std::string(why) + "; remove one of them");
}

const char* axis_name(std::size_t axis, int dimension) {
    if (axis == 0) return "x";
    return dimension == 3 && axis == 1 ? "y" : "z";
}

}  // namespace tidewater::scene
