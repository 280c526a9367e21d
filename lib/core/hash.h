// A 64-bit fingerprint of bytes (FNV-1a): equal bytes give equal numbers on every machine. Not for security.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tidewater {

inline constexpr std::uint64_t hash_start = 0xcbf29ce484222325ULL;

// Continues `hash` over the bytes, so that hash_bytes(b, hash_bytes(a)) is the fingerprint of a followed by
// b.
std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash = hash_start);

std::uint64_t hash_text(std::string_view text, std::uint64_t hash = hash_start);

// Sixteen lower-case hexadecimal digits.
std::string hash_hex(std::uint64_t hash);

}  // namespace tidewater
