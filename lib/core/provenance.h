// Where a file comes from; every output carries it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tidewater {

struct Provenance {
    std::string program;     // "tidewater-simulate"
    std::string version;     // program_version()
    std::string command;     // reproducible_command()
    std::string scene_hash;  // scene::scene_hash()
    std::uint64_t seed = 0;
};

std::string program_version();

// Fingerprint of the running executable's file: the same version may be compiled in many ways, of which only
// one gives the same bits. Empty where the system does not tell.
std::string program_fingerprint();

// argv joined by blanks, without what cannot change a result: --threads N, --run FOLDER, --from CHECKPOINT,
// --until TIME (also with = between) and the folders of argv[0] and of the scene file. So the same scene
// gives the same bytes wherever, with however many threads and in however many pieces it runs.
std::string reproducible_command(int argc, const char* const* argv);

// The fields as (name, text) in a fixed order, for writers of attributes and comment lines. Each text is one
// line: control characters, say of a title with a line break, become \x0a and the like.
std::vector<std::pair<std::string, std::string>> provenance_fields(const Provenance& provenance);

}  // namespace tidewater
