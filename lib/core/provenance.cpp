#include "core/provenance.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"

namespace tidewater {
namespace {

// Control characters as \x0a.
std::string one_line(const std::string& text) {
    std::string line;
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        char escape[8];
        std::snprintf(escape, sizeof escape, "\\x%02x", static_cast<unsigned>(code));
        line += code < 0x20 || code == 0x7f ? std::string(escape) : std::string(1, letter);
    }
    return line;
}

// Options with a value that cannot change a result.
constexpr std::array<std::string_view, 4> left_out{"--threads", "--run", "--from", "--until"};

bool is_left_out(std::string_view option) {
    return std::find(left_out.begin(), left_out.end(), option) != left_out.end();
}

}  // namespace

std::string program_version() { return TIDEWATER_VERSION; }

std::string program_fingerprint() {
    try {
        return hash_hex(hash_text(read_text("/proc/self/exe")));
    } catch (const Error&) {
        return {};
    }
}

std::string reproducible_command(int argc, const char* const* argv) {
    const auto name_of = [](std::string_view path) {
        return std::filesystem::path(path).filename().string();
    };
    std::string command = argc > 0 ? name_of(argv[0]) : std::string();
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (is_left_out(word)) {
            ++i;
        } else if (word == "--set" && i + 1 < argc) {
            command.append(" --set ").append(argv[++i]);
        } else if (!is_left_out(word.substr(0, word.find('=')))) {
            command.append(" ").append(word.starts_with("-") ? std::string(word) : name_of(word));
        }
    }
    return command;
}

std::vector<std::pair<std::string, std::string>> provenance_fields(const Provenance& provenance) {
    return {{"program", one_line(provenance.program)},
            {"version", one_line(provenance.version)},
            {"command", one_line(provenance.command)},
            {"scene_hash", one_line(provenance.scene_hash)},
            {"seed", std::to_string(provenance.seed)}};
}

}  // namespace tidewater
