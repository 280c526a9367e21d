#include "scene/keys.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("every key is declared once, with a help text and a stage that reads it") {
    std::set<std::string_view> names;
    for (const Key& key : all_keys()) {
        CHECK_MESSAGE(names.insert(key.name).second, key.name);
        CHECK_MESSAGE(!key.help.empty(), key.name);
        CHECK_MESSAGE(key.stages != 0, key.name);
        CHECK(find_key(key.name) == &key);
    }
    CHECK(find_key("water.dpeth") == nullptr);
}

TEST_CASE("every effect that a key names is known") {
    for (const Key& key : all_keys()) {
        if (!key.effect.empty()) CHECK(std::ranges::count(known_effects(), key.effect) == 1);
    }
}

TEST_CASE("the keys of a section stand together, so that it is printed once") {
    std::set<std::string_view> closed;
    std::string_view open;
    for (const Key& key : all_keys()) {
        if (key.section() == open) continue;
        CHECK_MESSAGE(closed.insert(open).second, key.name);
        open = key.section();
    }
}

TEST_CASE("every default and every example is a value that the key takes") {
    for (const Key& key : all_keys()) {
        Scene scene;
        if (!key.required) {
            CHECK_MESSAGE(set_value(key, parse_value(value_text(key, scene)), scene) == "", key.name);
        }
        if (!key.example.empty()) {
            CHECK_MESSAGE(set_value(key, parse_value(std::string(key.example)), scene) == "", key.name);
        }
        if (key.required) CHECK_MESSAGE(!key.example.empty(), key.name);
    }
}

TEST_CASE("keys reach members of their own") {
    for (const Key& key : all_keys()) {
        Scene scene;
        const auto change = [&](const auto& member) {
            auto& value = member.write(scene, 0);
            using T = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<T, bool>)
                value = !value;
            else if constexpr (std::is_same_v<T, std::string>)
                value = "changed";
            else if constexpr (std::is_same_v<T, std::vector<double>>)
                value = {7.0};
            else if constexpr (std::is_same_v<T, Points>)
                value = {{7.0}, {1.0, 2.0}};
            else if constexpr (std::is_same_v<T, std::vector<std::string>>)
                value = {"changed"};
            else if constexpr (std::is_enum_v<T>)
                value = value == T{} ? static_cast<T>(1) : T{};
            else
                value = static_cast<T>(1 + static_cast<int>(value));
        };
        std::visit(change, key.member);
        const auto differs = [&](const Key& other) {
            return value_text(other, scene) != value_text(other, Scene{});
        };
        CHECK_MESSAGE(std::ranges::count_if(all_keys(), differs) == 1, key.name);
        CHECK_MESSAGE(differs(key), key.name);
    }
}

TEST_CASE("a value that is not taken leaves the scene as it was") {
    Scene scene;
    CHECK(set_value(*find_key("water.depth"), parse_value("-1"), scene) != "");
    CHECK(scene.water.depth == 0.0);
    const Key& surfaces = *find_key("postprocess.surfaces");
    CHECK(set_value(surfaces, parse_value("1"), scene) == "needs true or false, e.g. surfaces = true; got 1");
    CHECK(set_value(surfaces, parse_value("false"), scene) == "");
    CHECK(!scene.postprocess.surfaces);
}
