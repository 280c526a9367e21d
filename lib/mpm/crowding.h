// Crowding: how much more water there is at a place than fits, and how the scheme `density` ties the volumes
// of particles to it.
//
// A particle's J follows the divergence of the flow and so adds up the errors of every step, until it says
// nothing any more of the room that the particle has: pressure noise, which stirs the water, which makes more
// noise. The mass on the nodes does know the room. With φ the filled share of a node,
//
//     φ_i = m_i / (ρw Δx^D h_i) + s_i
//     e_i = φ_i − 1 where φ_i > least_fill, or φ − s > least_fill at the node above i; else 0
//     ē_i = e_i smoothed by (¼, ½, ¼) along each axis
//     J  ←  J + r (1/(1 + Σ w ē_i) − J),   r = min(Δt / √(Δx/g), greatest_rate)
//
// in addition to what the flow does, with J, φ and w all of the beginning of the step. (With φ one step older
// than J the feedback excites sound.) h_i is ½ for every mirroring wall on which the node lies, since only
// half of it is in the tank, and s_i is what rigid bodies have of it (mpm/rigid.h): so water keeps to the
// room outside of them. Where φ_i is low the water ends, and its pressure is about 0; but not below water, where it
// is a void, which closes once its particles have the volume that they have room for. (Without that a churned
// wake keeps its voids open: the level rises, and the energy.) A rigid body above does not make a void. A
// chequerboard on the nodes moves no water, so it must not press either: hence the smoothing.
//
// In a flow without errors φ J = 1 stays so, and long waves and still water notice nothing; at the surface,
// where e is cut off, waves of less than 50 cells lose about twice what they lose without. √(Δx/g), the time
// in which water falls through half a cell, is much shorter than a wave's period and much longer than sound
// needs for a cell.
//
// Where the mass on the nodes is not all water or partly lies beyond a wall that does not mirror, φ is not
// known; particles that touch such nodes, or whose nodes' neighbours are such, follow the flow alone. Which
// nodes these are is found when particles are sorted; the marks reach a cell further, so they hold until the
// next sort.
//
// Source: our own, of the family of volume corrections (lib/mpm/README.md, Water); measured against others in
// tests/validation/README.md. Test: tests/unit/mpm/crowding_test.cpp.
#pragma once

#include "mpm/simulation.h"

namespace tidewater::mpm {

inline constexpr double least_fill = 0.85;
inline constexpr double greatest_rate = 0.02;  // of J per step
// And J shrinks by a fifth in one step at most and does not grow beyond 2. What would pass these limits is a
// lone particle, in a splash or a film upon a wall: it alone moves its nodes and so keeps any divergence that
// it has, until J is 0 or infinite. Its J follows its room later.
inline constexpr double least_growth = -0.2, greatest_j = 1.0;  // ΔJ/J, J − 1
inline bool keeps_to_room(const WaterModel& water) { return water.scheme == WaterScheme::density; }

// r of a step of dt; 0 for the scheme `paper` and without gravity.
template <int D>
double crowding_rate(const Parameters<D>& parameters, double cell_size, double dt);

// Whether there is water in particle block `slot`; elsewhere nobody asks for the crowding.
template <int D, class Real>
bool has_water(const Simulation<D, Real>& s, std::size_t slot);

// Finds the nodes with unknown φ, for s.unknown_fill. Called when particles were sorted.
template <int D, class Real>
void mark_unknown_fill(Simulation<D, Real>& s);

// Writes ē into the mass lane of a tile of velocities of particle block `slot`; infinite where φ is not
// known.
template <int D, class Real>
void load_crowding(const Simulation<D, Real>& s, std::size_t slot, Node<Real>* tile);

}  // namespace tidewater::mpm
