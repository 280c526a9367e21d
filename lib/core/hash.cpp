#include "core/hash.h"

#include <cstdio>

namespace tidewater {

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash) {
    for (const std::byte byte : bytes) {
        hash ^= static_cast<std::uint64_t>(byte);
        hash *= 0x100000001b3ULL;
    }
    return hash;
}

std::uint64_t hash_text(std::string_view text, std::uint64_t hash) {
    return hash_bytes(std::as_bytes(std::span(text)), hash);
}

std::string hash_hex(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

}  // namespace tidewater
