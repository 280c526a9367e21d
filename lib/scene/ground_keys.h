// The keys of a piece of ground, under the section of the effect that has it: bed.friction, shelf.friction.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scene/ground.h"
#include "scene/keys.h"

namespace tidewater::scene {

struct Reading;

// The ground's keys under one section: its names in the order of `Ground`.
template <auto section, auto ground>
constexpr std::array<Key, 8> ground_keys(std::string_view effect,
                                         const std::array<std::string_view, 8>& names) {
    constexpr Range or_infinite{.min = 0.0, .infinite = true};
    return {
        Key{.name = names[0],
            .member = member<section, ground, &Ground::friction>(),
            .range = or_infinite,
            .effect = effect,
            .stages = by_simulate,
            .help = "of ice on it, Coulomb's coefficient: 0 slides freely, inf does not slide where it "
                    "presses"},
        Key{.name = names[1],
            .unit = "m/a",
            .member = member<section, ground, &Ground::sliding_speed>(),
            .range = not_negative,
            .effect = effect,
            .stages = by_simulate,
            .help = "at which friction is regularised: tau = friction N (u/(u + sliding_speed))^(1/m), "
                    "m the sliding_exponent; 0: Coulomb's law as it is"},
        Key{.name = names[2],
            .unit = "Pa (a/m)^(1/m)",
            .member = member<section, ground, &Ground::weertman>(),
            .range = not_negative,
            .effect = effect,
            .stages = by_simulate,
            .help = "coefficient C of Weertman's sliding of ice, tau = C u^(1/m); with friction too, the "
                    "smaller of the two resists; 0: none"},
        Key{.name = names[3],
            .member = member<section, ground, &Ground::sliding_exponent>(),
            .range = {.min = 1.0, .max = 100.0},
            .effect = effect,
            .stages = by_simulate,
            .help = "m of the two sliding laws"},
        Key{.name = names[4],
            .member = member<section, ground, &Ground::pore_pressure>(),
            .range = {.min = 0.0, .max = 1.0},
            .effect = effect,
            .stages = by_simulate,
            .help = "share of the still water's pressure at the ground that carries the ice, and does not "
                    "rub: 0 dry, 1 open to the sea"},
        Key{.name = names[5],
            .member = member<section, ground, &Ground::drag>(),
            .range = or_infinite,
            .effect = effect,
            .stages = by_simulate,
            .help = "of water on it, tau = drag rho u²: 0 glides, 0.002 to 0.005 in nature, inf holds the "
                    "water"},
        Key{.name = names[6],
            .unit = "s/m^(1/3)",
            .member = member<section, ground, &Ground::manning>(),
            .range = not_negative,
            .effect = effect,
            .stages = by_simulate,
            .help = "Manning's n in place of drag: 0.02 to 0.035 for natural beds; 0: none"},
        Key{.name = names[7],
            .member = member<section, ground, &Ground::wall>(),
            .effect = effect,
            .stages = by_simulate,
            .retired = true,
            .help = "no longer a key"}};
}

// a followed by b.
template <std::size_t n, std::size_t m>
constexpr std::array<Key, n + m> joined(const std::array<Key, n>& a, const std::array<Key, m>& b) {
    std::array<Key, n + m> all{};
    for (std::size_t i = 0; i < n; ++i) all[i] = a[i];
    for (std::size_t i = 0; i < m; ++i) all[n + i] = b[i];
    return all;
}

// Sets the keys that a retired <section>.wall stands for.
void derive_ground(Reading& reading, std::string_view section, Ground& ground);

void check_ground(Reading& reading, std::string_view section, const Ground& ground);

// What is probably not meant, one line each, or empty.
std::vector<std::string> ground_warnings(const Scene& scene, std::string_view section, const Ground& ground);

// A line that says how thick the layer of water becomes that `what` holds, or nothing in a scene without
// water. After n transfers, which lose 0.024 (kΔx)⁴ of a velocity each, or 0.024² (kΔx)⁸ where velocities are
// restored (lib/mpm/README.md, Grid and transfer), the layer is about δ = (0.024 n)^¼ Δx, or
// (0.024² n)^⅛ Δx, thick. n is reckoned from the fastest sound.
std::string held_layer(const Scene& scene, const std::string& what);

}  // namespace tidewater::scene
