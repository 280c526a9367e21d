// A 2D wave flume for tests: still water in a box, and the level at gauges as it goes.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mpm/particles/motion.h"
#include "support/tank.h"

namespace tidewater::test {

// Water of 1 m depth, `cells` cells deep, in a flume of this length with room for waves; sound at 30 m/s.
inline mpm::Start<2> flume_start(double length, int cells) {
    const double cell = 1.0 / cells;
    auto start =
        tank_start<2>(cell, {static_cast<int>(std::lround(length * cells)), 8 * cells / 5}, 1.0, 30.0);
    return start;
}

// The water's volume around x over the width, m; a smooth window of `reach` m to each side, in which the
// level of a whole particle more counts for little.
template <class Real>
double level_at(const mpm::Simulation<2, Real>& s, double x, double reach) {
    double volume = 0.0;
    for (const auto& particles : s.bodies) {
        for (std::size_t slot = 0; slot < s.grid.particle_blocks.size(); ++slot) {
            const mpm::Index<2> block = mpm::block_at<2>(s.grid.particle_blocks[slot]);
            const double low = s.grid.layout.cell_size * (s.grid.layout.first_node(block[0]) - 1);
            const double high = low + s.grid.layout.cell_size * (mpm::Block<2>::width + 2);
            if (x + reach < low || x - reach > high) continue;
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                const double from = mpm::global_position(s.grid.layout, block, particles, p)[0] - x;
                if (std::abs(from) >= reach) continue;
                const double now = particles.volume * (1.0 + static_cast<double>(particles.j[p]));
                volume += now * (1.0 + std::cos(std::numbers::pi * from / reach));
            }
        }
    }
    return 0.5 * volume / reach;
}

// The levels at the places, every `interval` s from 0 up to `until`: [place][n].
template <class Real>
std::vector<std::vector<double>> record_levels(const std::vector<double>& places, double interval,
                                               double until, mpm::Simulation<2, Real>& s) {
    std::vector<std::vector<double>> levels(places.size());
    const double reach = 0.4;
    for (int row = 0; row * interval <= until; ++row) {
        while (s.time < row * interval) {
            mpm::advance(s, mpm::stable_time_step(s));
        }
        for (std::size_t i = 0; i < places.size(); ++i) levels[i].push_back(level_at(s, places[i], reach));
    }
    return levels;
}

// A flume with a piston and, if `sponge` > 0, so many m of sponge at its end.
inline mpm::Start<2> piston_start(double length, int cells, mpm::Piston piston, double sponge) {
    auto start = flume_start(length, cells);
    piston.depth = 1.0;
    start.parameters.boundaries.piston = piston;
    if (sponge > 0.0) {
        const double celerity = std::sqrt(start.parameters.gravity * piston.depth);
        start.parameters.boundaries.sponge = {.from = length - sponge,
                                              .width = sponge,
                                              .rate = 10.0 * celerity / sponge,
                                              .level = piston.depth};
    }
    return start;
}

struct Echo {
    double height = 0.0;               // of the wave on its way to the sponge, m
    double crest = 0.0, trough = 0.0;  // that come back, shares of it
    double last = 0.0;                 // level after 20 s, likewise
    double taken = 0.0;                // water that left, shares of the wave's
};

// What a sponge sends back of a solitary wave of 0.2 m: at a gauge at 8 m, 4 m before the sponge, from when
// the crest is 8 m further on.
inline Echo echo_of(double sponge, int cells) {
    const double height = 0.2, interval = 0.05;
    auto s = mpm::make_simulation<2, float>(piston_start(12.0 + sponge, cells, {.height = height}, sponge));
    const auto levels = record_levels({8.0}, interval, 20.0, s).front();
    Echo echo{.height = *std::ranges::max_element(levels) - 1.0};
    for (auto n = static_cast<std::size_t>(7.5 / interval); n < levels.size(); ++n) {
        echo.last = (levels[n] - 1.0) / echo.height;
        echo.crest = std::max(echo.crest, echo.last);
        echo.trough = std::min(echo.trough, echo.last);
    }
    echo.taken = s.accounts.outflow.mass / (1000.0 * 2.0 * height / std::sqrt(0.75 * height));
    return echo;
}

}  // namespace tidewater::test
