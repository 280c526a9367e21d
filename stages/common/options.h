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

struct StageOptions {
    std::filesystem::path scene;
    std::filesystem::path run;  // never empty: runs/<stem of the scene file> by default
    std::vector<std::string> set;
    int threads = 0;  // 0: all cores
    bool check = false;
    bool print_scene = false;
    std::optional<scene::Stage> print_part;

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
