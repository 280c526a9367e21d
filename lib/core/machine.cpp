#include "core/machine.h"

#include <tbb/info.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <ctime>
#include <fstream>
#include <string_view>

namespace tidewater {
namespace {

// The rest of the first line "<name> : <value>"; empty if the file has none.
std::string value_of(const char* file, std::string_view name) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with(name)) continue;
        const auto colon = line.find(':');
        const auto from = colon == line.npos ? line.npos : line.find_first_not_of(" \t", colon + 1);
        return from == line.npos ? std::string() : line.substr(from);
    }
    return {};
}

// Of a value that is given as "<number> kB".
std::optional<std::int64_t> bytes_of(const char* file, std::string_view name) {
    const std::string text = value_of(file, name);
    std::int64_t kilobytes = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), kilobytes).ec != std::errc()) return {};
    return 1024 * kilobytes;
}

}  // namespace

Machine this_machine() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
    return {.host = host.data(),
            .cpu = value_of("/proc/cpuinfo", "model name"),
            .cores = tbb::info::default_concurrency(),
            .memory_bytes = bytes_of("/proc/meminfo", "MemTotal")};
}

std::optional<std::int64_t> peak_memory_bytes() { return bytes_of("/proc/self/status", "VmHWM"); }

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

}  // namespace tidewater
