// A 2D wave flume for tests: still water in a box, and the level at gauges as it goes.
#pragma once

#include <cmath>
#include <numbers>

#include "mpm/motion.h"
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
                volume += particles.volume * (1.0 + std::cos(std::numbers::pi * from / reach));
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

}  // namespace tidewater::test
