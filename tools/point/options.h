// The command line of tidewater-point.
#pragma once

#include <filesystem>
#include <optional>

#include "mpm/materials/ice.h"
#include "mpm/materials/single_point.h"

namespace tidewater::point {

struct Options {
    mpm::IceModel ice;
    mpm::Loading loading;
    int dimension = 3;
    bool single_precision = false;  // float, as the engine by default
    bool failed = false;            // starts at α = 0 instead of α0
    std::filesystem::path out = "point";
};

// Empty after --help and --version, which are answered on standard output.
// Throws SceneError with what is wrong with the command line.
std::optional<Options> parse_options(int argc, const char* const* argv);

}  // namespace tidewater::point
