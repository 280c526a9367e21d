// Spray: water without neighbours bears no pressure.
//
// On the grid a drop meets still water when their kernels touch, up to three cells early. If the drop is a
// little compressed then, its pressure carries it: a group of four particles that flies along still water
// skims over 35 cells at a height of one and a half. And a drop that was squeezed out of a narrow place keeps
// its compression, and with it the speed of sound that everything has to step by.
//
// So particles whose place is hardly filled,
//
//     φ_p = Σ w φ_i < lone_share^d,    φ as in mpm/step/crowding.h,
//
// are opened: J ← max(J, 1 + lone_opening). Stretched water has no pressure and, since it remembers how far
// it is open, bears none until it has closed again; drops fly as stones do, sink into what they meet and give
// it their momentum through the nodes. A film of one particle, half a cell, is open too. Only elastic energy
// is lost. Opening by more would cost volume beside walls, where only J knows it.
//
// lone_share: a single particle has φ_p of 0.38 to 0.59 per axis over half a cell of room, a 2 × 2 (× 2) drop
// 0.5 per axis, the corner of a block of water 0.66.
//
// Asked at every sort, of the scheme `density` with the tension `separate`; others keep what they have.
// Tests: tests/unit/mpm/step/spray_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

inline constexpr double lone_share = 0.55;   // of room, per axis
inline constexpr double lone_opening = 0.1;  // J − 1

// Opens the lone water, by the masses on the nodes, which must be those of the particles' present places.
template <int D, class Real>
void open_spray(const WaterModel& water, const Grid<D, Real>& grid, const std::vector<RigidBody>& rigid,
                std::vector<Particles<D, Real>>& bodies);

}  // namespace tidewater::mpm
