#include "scene/effects/effects.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

namespace {

// The names of the files in lib/scene/effects with this ending, without it.
std::set<std::string> effect_files(const std::string& ending) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(EFFECTS_FOLDER)) {
        if (entry.path().extension() == ending) names.insert(entry.path().stem().string());
    }
    return names;
}

}  // namespace

TEST_CASE("the names of effects are unique") {
    const std::set<std::string> names(known_effects().begin(), known_effects().end());
    CHECK(names.size() == all_effects().size());
    CHECK(known_effects().size() == all_effects().size());
}

TEST_CASE("every effect has a header and a source of its name, and every such file is an effect") {
    std::set<std::string> sources(known_effects().begin(), known_effects().end());
    std::set<std::string> headers = sources;
    headers.insert({"effect", "effects"});
    sources.insert("effects");
    CHECK(effect_files(".h") == headers);
    CHECK(effect_files(".cpp") == sources);
}

TEST_CASE("every effect has keys, which name it and share one section") {
    for (const Effect* effect : all_effects()) {
        REQUIRE_MESSAGE(!effect->keys.empty(), effect->name);
        for (const Key& key : effect->keys) {
            CHECK_MESSAGE(key.effect == effect->name, key.name);
            CHECK_MESSAGE(key.section() == effect->keys.front().section(), key.name);
            CHECK_MESSAGE(key.repeated() == effect->keys.front().repeated(), key.name);
        }
    }
}

TEST_CASE("every effect that a key names is in the table") {
    for (const Key& key : all_keys()) {
        if (!key.effect.empty())
            CHECK_MESSAGE(std::ranges::count(known_effects(), key.effect) == 1, key.name);
    }
}

TEST_CASE("an effect that may occur several times counts its items in the scene") {
    Scene scene;
    for (const Key& key : all_keys()) {
        if (!key.repeated()) continue;
        CHECK_MESSAGE(key.count(scene) == 1, key.name);
        key.member.resize(scene, 3);
        CHECK_MESSAGE(key.count(scene) == 3, key.name);
        CHECK_MESSAGE(
            key.name_of(1, scene) == std::string(key.section()) + ".2." + std::string(key.last_name()),
            key.name);
        key.member.resize(scene, 1);
    }
    REQUIRE(repeated_sections().size() == 1);
    CHECK(repeated_sections()[0] == "block");
}

TEST_CASE("a glacier with everything on it is in order") {
    CHECK(problem(glacier_scene,
                  {"effects=[\"water\", \"ice\", \"fracture\", \"cliff\", \"undercut\", \"crevasses\", "
                   "\"cracks\"]",
                   "cliff.amplitude=10", "undercut.depth=10", "undercut.height=20", "crevasses.spacing=90",
                   "cracks.cell_size=40", "cracks.width=1", "cracks.cohesion=0.3"}) == "");
}
