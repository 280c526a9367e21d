#include "core/provenance.h"

#include <filesystem>
#include <string_view>

namespace tidewater {

std::string program_version() { return TIDEWATER_VERSION; }

std::string reproducible_command(int argc, const char* const* argv) {
    std::string command = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : std::string();
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--threads" || word == "--run") {
            ++i;
        } else if (!word.starts_with("--threads=") && !word.starts_with("--run=")) {
            command.append(" ").append(word);
        }
    }
    return command;
}

std::vector<std::pair<std::string, std::string>> provenance_fields(const Provenance& provenance) {
    return {{"program", provenance.program},
            {"version", provenance.version},
            {"command", provenance.command},
            {"scene_hash", provenance.scene_hash},
            {"seed", std::to_string(provenance.seed)}};
}

}  // namespace tidewater
