// The one error type: a line that says what is wrong, where, and what to do, and the exit code it ends the
// program with.
#pragma once

#include <stdexcept>
#include <string>

namespace tidewater {

enum class ExitCode : int { ok = 0, scene = 2, input = 3, numerics = 4, output = 5 };

class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

// The scene file or a command-line option is wrong.
struct SceneError : Error {
    explicit SceneError(const std::string& line) : Error(ExitCode::scene, line) {}
};

// A file that a stage reads is missing, truncated, foreign or of another version.
struct InputError : Error {
    explicit InputError(const std::string& line) : Error(ExitCode::input, line) {}
};

// The computation left its valid range: NaN, an escaped particle, a collapsed volume.
struct NumericsError : Error {
    explicit NumericsError(const std::string& line) : Error(ExitCode::numerics, line) {}
};

// A result cannot be written.
struct OutputError : Error {
    explicit OutputError(const std::string& line) : Error(ExitCode::output, line) {}
};

}  // namespace tidewater
