// What the tests of scenes share: a scene that is in order, and reading texts as if they were scene files.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/scene.h"
#include "support/temporary_folder.h"

namespace tidewater::scene {

// A block above a tank in 2D: only the keys that have no default, one to a line.
inline const std::string block_scene = R"(effects = ["water", "rigid"]
[domain]
size = [16, 1]
cell_size = 0.01
[water]
depth = 0.5
[block]
size = [0.5, 0.25]
center = [0.3, 0.7]
[simulate]
end_time = 10
snapshot_interval = 0.1
)";

// A tank of water in 3D.
inline const std::string water_scene_3d = R"(dimension = 3
effects = ["water"]
domain.size = [4, 2, 1]
domain.cell_size = 0.1
water.depth = 0.5
simulate.end_time = 1
simulate.snapshot_interval = 0.1
)";

// A slab of ice on a shelf is pushed into water that a submergence gives.
inline const std::string slab_scene =
    R"(effects = ["water", "ice", "fracture", "shelf", "push", "outlet", "settle"]
[domain]
size = [60, 24]
cell_size = 1
[water]
submergence = 0.25
[ice]
size = [34, 8]
corner = [0, 10]
[shelf]
length = 30
height = 10
[push]
speed = 2
[outlet]
width = 12
[simulate]
end_time = 3
snapshot_interval = 0.5
)";

// 300 m of ice, 100 m high, behind 200 m of water.
inline const std::string glacier_scene = R"(effects = ["water", "ice", "fracture"]
[domain]
size = [500, 150]
cell_size = 2.5
[water]
depth = 50
[ice]
size = [300, 100]
corner = [0, 0]
[simulate]
end_time = 3
snapshot_interval = 0.5
)";

// A flume with a slope, a wave maker and a sponge.
inline const std::string flume_scene = R"(effects = ["water", "bed", "piston", "sponge"]
[domain]
size = [20, 2]
cell_size = 0.1
[water]
depth = 1
[bed]
profile = [8, 0, 10, 0.5]
[piston]
height = 0.2
[sponge]
width = 6
[simulate]
end_time = 3
snapshot_interval = 0.5
)";

using Sets = std::vector<std::string>;  // as after --set

inline Scene read_text_as_scene(const std::string& text, const Sets& sets = {}) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "a.toml") << text;
    std::vector<Override> overrides;
    for (const std::string& set : sets) overrides.push_back(parse_override(set));
    return read_scene(folder.path() / "a.toml", overrides);
}

// The lines of the SceneError, from "a.toml" on; none if the scene is in order.
inline std::vector<std::string> problems(const std::string& text, const Sets& sets = {}) {
    std::vector<std::string> lines;
    try {
        read_text_as_scene(text, sets);
    } catch (const SceneError& error) {
        std::istringstream stream(error.what());
        for (std::string line; std::getline(stream, line);) {
            const auto name = line.find("a.toml");
            lines.push_back(name == line.npos ? line : line.substr(name));
        }
    }
    return lines;
}

// The only problem; all of them, joined, if there are several.
inline std::string problem(const std::string& text, const Sets& sets = {}) {
    std::string joined;
    for (const std::string& line : problems(text, sets)) joined += (joined.empty() ? "" : "\n") + line;
    return joined;
}

// The problem of a scene with this setting, without the "--set key=value: " that leads it.
inline std::string set_problem(const std::string& set, const std::string& text = block_scene) {
    const std::string line = problem(text, {set});
    const std::string lead = "--set " + set + ": ";
    return line.starts_with(lead) ? line.substr(lead.size()) : line;
}

// Fails unless the problems of a scene with these settings contain a text.
inline void tells(const std::string& text, const Sets& sets, const std::string& what) {
    const std::string lines = problem(text, sets);
    CAPTURE(lines);
    CHECK(lines.find(what) != std::string::npos);
}

}  // namespace tidewater::scene
