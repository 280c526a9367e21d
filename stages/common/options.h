// The command line of every stage. No other file of the stages uses CLI11.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace tidewater {

// Frames of another program, instead of simulate's.
struct ParticleOptions {
    std::vector<std::filesystem::path> files;  // empty: simulate's frames
    std::string map, materials;                // io/column_map.h; empty: none
    std::string up = "z";                      // or "y"
    std::vector<double> origin;                // m, x, y, z in the files' axes; empty: theirs is the scene's
    std::vector<double> times;                 // s, of each file; empty: as the files tell
};

struct StageOptions {
    std::filesystem::path scene;
    std::filesystem::path run;  // never empty: runs/<stem of the scene file> by default
    std::vector<std::string> set;
    int threads = 0;  // 0: all cores
    bool check = false;
    bool print_scene = false;
    std::optional<scene::Stage> print_part;

    // Of postprocess alone.
    ParticleOptions particles;

    // Of simulate alone.
    std::string from;  // "start", or the checkpoint to go on from; empty: the run's own if there is one
    double until = std::numeric_limits<double>::infinity();  // s, simulated

    bool movie = false;  // of postprocess alone
};

// Empty after --help, --help-scene and --version, which are answered on standard output.
// Throws SceneError with what is wrong with the command line.
std::optional<StageOptions> parse_options(int argc, const char* const* argv, scene::Stage stage,
                                          std::string_view description);

}  // namespace tidewater
