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

// argv joined by blanks, without what cannot change a result: --threads N, --run FOLDER (or --threads=N,
// --run=FOLDER) and the folders of argv[0] and of the scene file. So the same scene gives the same bytes
// wherever and with however many threads it runs.
std::string reproducible_command(int argc, const char* const* argv);

// The fields as (name, text) in a fixed order, for writers of attributes and comment lines. Each text is one
// line: control characters, say of a title with a line break, become \x0a and the like.
std::vector<std::pair<std::string, std::string>> provenance_fields(const Provenance& provenance);

}  // namespace tidewater
