// Counter-based random numbers: the value depends on (seed, stream, counter) alone, so any thread may ask for
// any one. Mixing function: two rounds of the finaliser of SplitMix64 (Steele, Lea & Flood 2014, "Fast
// splittable pseudorandom number generators").
#pragma once

#include <cstdint>

namespace tidewater {

inline std::uint64_t mix64(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

// Uniform in [0, 1), 53 bits.
inline double random_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
    return static_cast<double>(mix64(mix64(seed ^ mix64(stream)) ^ counter) >> 11) * 0x1.0p-53;
}

}  // namespace tidewater
