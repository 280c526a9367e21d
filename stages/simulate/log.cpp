#include "log.h"

#include <cstdio>

namespace tidewater {

Log::Log(const std::filesystem::path& folder) : part_(folder / "log"), stream_(part_.part_path()) {}

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
