// A scene while it is being read: what is set so far, where, and what is wrong with it.
#pragma once

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace tidewater::scene {

struct Reading {
    std::string file;
    Scene scene;
    std::map<std::string, std::string, std::less<>>
        places;                                   // key -> "x.toml:12: water.depth", "--set water.depth=2"
    std::set<std::string, std::less<>> unusable;  // missing or wrong; checks that need them are left out
    std::vector<std::string> problems;

    bool usable(std::initializer_list<std::string_view> keys) const;

    // Appends "<where the key was set>: <problem>".
    void report(std::string_view key, const std::string& problem);
};

// Checks the keys against each other, appending what is wrong.
void check_scene(Reading& reading);

// Parts of it, in check_flume.cpp.
void check_bed(Reading& reading);
void check_piston(Reading& reading);
void check_sponge(Reading& reading);

}  // namespace tidewater::scene
