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

    // "block.size" stands for that of every block.
    bool usable(std::initializer_list<std::string_view> keys) const;

    // Marks a key, in its full name, as unusable.
    void spoil(const std::string& key);

    // Appends a line, unless it is there already: one --set may be wrong for several blocks.
    void add(const std::string& problem);

    // Appends "<where the key was set>: <problem>".
    void report(std::string_view key, const std::string& problem);
};

// Checks the keys against each other, appending what is wrong.
void check_scene(Reading& reading);

// Keys of ice and ground that follow from others: profiles from files; the box of an outline, and where ice
// floats. Report what stands in their way. In derive_glacier.cpp.
void read_profiles(Reading& reading);
void derive_glacier(Reading& reading);

// Parts of it, in check_blocks.cpp, check_glacier.cpp and check_flume.cpp.
void check_blocks(Reading& reading);
void check_glacier(Reading& reading);
void check_bed(Reading& reading);
void check_piston(Reading& reading);
void check_sponge(Reading& reading);

// What of the rigid blocks is allowed but probably not meant, and how fast they will move by an estimate,
// m/s.
std::vector<std::string> block_warnings(const Scene& scene);
double fastest_block(const Scene& scene);
std::vector<std::string> glacier_warnings(const Scene& scene);

// "block.size", or "block.2.size" for the second of several.
std::string block_key(const Scene& scene, std::size_t block, std::string_view name);
// "the block", "block 2".
std::string block_name(const Scene& scene, std::size_t block);

const char* axis_name(std::size_t axis, int dimension);

inline constexpr double tolerance = 1e-6;  // of a cell

}  // namespace tidewater::scene
