#include "core/provenance.h"

#include <filesystem>

namespace tidewater {

std::string program_version() { return TIDEWATER_VERSION; }

std::string reproducible_command(int argc, const char* const* argv) {
    std::string command = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : std::string();
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--threads") {
            ++i;
        } else if (word.rfind("--threads=", 0) != 0) {
            command += " " + word;
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
