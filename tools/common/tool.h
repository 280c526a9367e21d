// What the mains of the small tools share: the command line, errors and exit codes.
//
//     int main(int argc, char** argv) {
//         return tidewater::run_tool("tidewater-overhang", argc, argv, &tidewater::overhang::run);
//     }
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "core/error.h"

namespace tidewater {

// False after --help and --version, which are answered on standard output. Throws SceneError with what is
// wrong with the command line.
inline bool parse_command_line(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answered) {
        app.exit(answered);
        return false;
    } catch (const CLI::ParseError& error) {
        throw SceneError(std::string(error.what()) + "; --help lists the options");
    }
    return true;
}

// Runs `work`; a line on standard error for what it throws. Returns the exit code of core/error.h, 1 for what
// is no Error of ours.
inline int run_tool(const char* name, int argc, const char* const* argv,
                    void (*work)(int argc, const char* const* argv)) {
    try {
        work(argc, argv);
        return static_cast<int>(ExitCode::ok);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s: %s\n", name, error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: unexpected error, please report it: %s\n", name, error.what());
        return 1;
    }
}

}  // namespace tidewater
