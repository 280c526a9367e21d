#include "log.h"

#include <cstdio>

namespace tidewater {

namespace {

// What an earlier process wrote: under the part's name if it was killed.
std::string earlier_text(const std::filesystem::path& folder) {
    for (const char* name : {"log.part", "log"}) {
        if (std::filesystem::exists(folder / name)) return read_text(folder / name) + "\n";
    }
    return {};
}

}  // namespace

Log::Log(const std::filesystem::path& folder, bool go_on)
    : earlier_(go_on ? earlier_text(folder) : ""), part_(folder / "log"), stream_(part_.part_path()) {
    stream_ << earlier_ << std::flush;
}

void Log::line(const std::string& text) {
    std::fprintf(stderr, "%s\n", text.c_str());
    quiet_line(text);
}

void Log::quiet_line(const std::string& text) { stream_ << text << std::endl; }

void Log::finish() {
    stream_.close();
    part_.commit();
}

}  // namespace tidewater
