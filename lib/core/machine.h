// The machine that a program runs on, as Linux tells it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tidewater {

struct Machine {
    std::string host;  // empty: unknown, as cpu
    std::string cpu;   // "Intel(R) Xeon(R) Platinum 8481C CPU @ 2.70GHz"
    int cores = 0;     // logical ones that this process may use
    std::optional<std::int64_t> memory_bytes;
};

Machine this_machine();

// The largest resident memory of this process so far; nothing where the system does not tell.
std::optional<std::int64_t> peak_memory_bytes();

// Now, in UTC, by ISO 8601 to the second: "2026-01-31T18:05:00Z".
std::string utc_now();

}  // namespace tidewater
