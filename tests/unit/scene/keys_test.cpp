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

namespace {

// A value of the same type that differs from the one that the key has in the scene.
Value other_value(const Key& key, const Scene& scene) {
    struct Change {
        const Member& member;

        Value operator()(bool truth) const { return !truth; }
        Value operator()(double number) const { return number + 1.0; }
        Value operator()(std::int64_t whole) const { return whole + 1; }
        Value operator()(const std::string& text) const {
            if (member.names.empty()) return text + "changed";
            return std::string(text == member.names[0] ? member.names[1] : member.names[0]);
        }
        Value operator()(const std::vector<double>&) const { return std::vector{7.0}; }
        Value operator()(const Points&) const { return Points{{7.0}, {1.0, 2.0}}; }
        Value operator()(const std::vector<std::string>&) const {
            return std::vector<std::string>{"changed"};
        }
        Value operator()(const Foreign& foreign) const { return foreign; }
    };
    return std::visit(Change{key.member}, key.member.get(scene, 0));
}

}  // namespace

TEST_CASE("keys reach members of their own") {
    for (const Key& key : all_keys()) {
        Scene scene;
        CHECK_MESSAGE(key.member.set(scene, 0, other_value(key, scene)), key.name);
        const auto differs = [&](const Key& other) {
            return value_text(other, scene) != value_text(other, Scene{});
        };
        CHECK_MESSAGE(std::ranges::count_if(all_keys(), differs) == 1, key.name);
        CHECK_MESSAGE(differs(key), key.name);
    }
}

TEST_CASE("a key takes every name of its enum, and prints it") {
    for (const Key& key : all_keys()) {
        for (const std::string_view name : key.member.names) {
            Scene scene;
            CHECK_MESSAGE(set_value(key, std::string(name), scene) == "", key.name);
            CHECK_MESSAGE(value_text(key, scene) == "\"" + std::string(name) + "\"", key.name);
        }
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
